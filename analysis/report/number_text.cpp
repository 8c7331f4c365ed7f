#include "analysis/report/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

constexpr int kMaxDecimals = 6;
constexpr double kLargest = 1e6;  ///< that is written without an exponent

bool hasInterval(double value, double lower, double upper) {
  return std::isfinite(value) && std::isfinite(lower) && std::isfinite(upper) && upper > lower;
}

/// So that the shorter half of the interval has two significant digits, and no bound is
/// rounded to 0.
int decimalsOf(double value, double lower, double upper) {
  const double shorter = std::min(value - lower, upper - value);
  const double half = shorter > 0 ? shorter : (upper - lower) / 2;  // the estimate may be a bound
  const auto firstDigit = [](double number) { return -static_cast<int>(std::floor(std::log10(number))); };
  const int decimals = std::max(0, 1 + firstDigit(half));
  return lower > 0 ? std::max(decimals, firstDigit(lower)) : decimals;
}

}  // namespace

std::string numberText(double value) {
  if (!std::isfinite(value)) {
    return "not known";
  }
  const double size = std::abs(value);
  return size >= 100 && size < kLargest ? fmt::format("{:.1f}", value) : fmt::format("{:#.3g}", value);
}

std::string fixedText(double value, int decimals) {
  if (std::abs(value) >= kLargest) {
    return fmt::format("{:.2e}", value);
  }
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  return text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos ? text.substr(1) : text;
}

EstimateTexts textsOf(const Estimate& estimate) {
  EstimateTexts texts;
  if (!hasInterval(estimate.value, estimate.lower, estimate.upper)) {
    texts.value = std::isfinite(estimate.value) ? numberText(estimate.value) : "";
    texts.standardError = std::isfinite(estimate.standardError) ? numberText(estimate.standardError) : "";
    return texts;
  }
  const int decimals = decimalsOf(estimate.value, estimate.lower, estimate.upper);
  const auto text = [&](double number) {
    return decimals <= kMaxDecimals ? fixedText(number, decimals) : numberText(number);
  };
  texts.value = text(estimate.value);
  texts.interval = fmt::format("{} to {}", text(estimate.lower), text(estimate.upper));
  texts.standardError = std::isfinite(estimate.standardError) ? text(estimate.standardError) : "";
  return texts;
}

std::string estimateText(double value, double lower, double upper) {
  Estimate estimate;
  estimate.value = value;
  estimate.lower = lower;
  estimate.upper = upper;
  const EstimateTexts texts = textsOf(estimate);
  return texts.interval.empty() ? numberText(value) : fmt::format("{} ({})", texts.value, texts.interval);
}

std::string statisticText(const Estimate& estimate) {
  if (!std::isfinite(estimate.statistic)) {
    return "";
  }
  return fmt::format("{} = {}", std::isfinite(estimate.degreesOfFreedom) ? "t" : "z", fixedText(estimate.statistic, 2));
}

std::string degreesText(double degreesOfFreedom) {
  return std::isfinite(degreesOfFreedom) ? fixedText(degreesOfFreedom, 1) : "";
}

std::string pValueText(double pValue) {
  return !std::isfinite(pValue) ? "" : pValue < 0.001 ? "< 0.001" : fmt::format("{:.3f}", pValue);
}

std::string pText(double pValue) {
  if (!std::isfinite(pValue)) {
    return "p not known";
  }
  return pValue < 0.001 ? "p < 0.001" : fmt::format("p = {:.3f}", pValue);
}

}  // namespace ocelli
