#include "analysis/plot/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ocelli {
namespace {

constexpr double kAxisLabelGap = 5;  // points between labels
constexpr double kSlack = 1e-9;      // of rounding, relative
constexpr int kMaxIntervals = 8;
constexpr int kFarthestDecade = 300;  // numbers end at 308
/// A narrower range, relative to its values, is rounding: they are all alike.
constexpr double kNarrowest = 1e-9;

/// 1, 2, 2.5 or 5 times a power of ten, at least as large.
double roundStep(double atLeast, bool whole) {
  const double step = whole ? std::max(atLeast, 1.0) : atLeast;
  const double unit = std::pow(10, std::floor(std::log10(step) + kSlack));
  for (const double mantissa : {1.0, 2.0, 2.5, 5.0, 10.0}) {
    const double candidate = mantissa * unit;
    if (candidate >= step * (1 - kSlack) && !(whole && candidate != std::round(candidate))) {
      return candidate;
    }
  }
  return 10 * unit;
}

int decimalsOf(double step) {
  for (int decimals = 0; decimals < 12; ++decimals) {
    const double scaled = step * std::pow(10, decimals);
    if (std::abs(scaled - std::round(scaled)) < 1e-6 * scaled) {
      return decimals;
    }
  }
  return 12;
}

std::string tickText(const AxisRange& range, double value, int decimals) {
  constexpr double kMaxWritten = 1e10;  // digits of larger numbers would fill the chart
  if (std::abs(value) >= kMaxWritten) {
    return fmt::format("{:.3g}", value);
  }
  return range.percent ? percentText(value, std::max(0, decimals - 2)) : numberText(value, decimals);
}

/// Of mantissa times 10 to the power of `decade`.
std::string decadeText(const AxisRange& range, int mantissa, int decade) {
  constexpr int kMaxZeros = 6;
  if (!range.percent && std::abs(decade) > kMaxZeros) {
    return fmt::format("{}e{}", mantissa, decade);
  }
  return tickText(range, mantissa * std::pow(10, decade), std::max(0, -decade));
}

/// The marks of a decade, from few to many.
constexpr std::array<std::array<bool, 10>, 3> kDecadeMarks{
    {{false, true}, {false, true, false, true}, {false, true, true, false, false, true}}};

}  // namespace

AxisRange AxisRange::of(const std::vector<double>& values, AxisScale scale) {
  AxisRange range;
  range.scale = scale;
  bool any = false;
  for (const double value : values) {
    if (std::isfinite(value) && (scale == AxisScale::kLinear || value > 0)) {
      range.low = any ? std::min(range.low, value) : value;
      range.high = any ? std::max(range.high, value) : value;
      any = true;
    }
  }
  if (!any) {
    range.low = scale == AxisScale::kLog ? 1 : 0;
    range.high = scale == AxisScale::kLog ? 10 : 1;
  } else {
    range.widenIfNarrow();
  }
  return range;
}

void AxisRange::widenIfNarrow() {
  const double size = std::max(std::abs(low), std::abs(high));
  if (high - low > kNarrowest * size) {
    return;
  }
  const double around = size == 0 ? 1 : size / 2;
  low -= around;
  high += around;
}

AxisRange AxisRange::with(double value) const {
  AxisRange range = *this;
  if (std::isfinite(value) && (scale == AxisScale::kLinear || value > 0)) {
    range.low = std::min(low, value);
    range.high = std::max(high, value);
  }
  return range;
}

Axis::Axis(const AxisRange& given, double from, double to, const std::function<double(const std::string&)>& labelLength)
    : scale_(given.scale), from_(from), to_(to) {
  AxisRange range = given;
  range.widenIfNarrow();
  if (scale_ == AxisScale::kLog) {
    // Steps 0 to 2 mark all of 1, 2, 5; 1, 3; 1 of each decade; later ones every second, third ... decade.
    for (int step = 0; step < 300; ++step) {
      layLog(range, step);
      if (fits(labelLength)) {
        return;
      }
    }
    return;
  }
  for (int intervals = kMaxIntervals; intervals > 0; --intervals) {
    layLinear(range, intervals);
    if (fits(labelLength)) {
      return;
    }
  }
}

void Axis::layLinear(const AxisRange& range, int intervals) {
  const double span = range.high - range.low;
  const double unit = range.percent ? 0.01 : 1;
  const double step = unit * roundStep(span / unit / intervals, range.whole);
  const double first = range.roundLow ? std::floor(range.low / step + kSlack) : std::ceil(range.low / step - kSlack);
  const double last = range.roundHigh ? std::ceil(range.high / step - kSlack) : std::floor(range.high / step + kSlack);
  low_ = range.roundLow ? first * step : range.low;
  high_ = range.roundHigh ? last * step : range.high;
  ticks_.clear();
  for (double i = first; i <= last; ++i) {
    const double value = i == 0 ? 0 : i * step;
    ticks_.push_back({value, tickText(range, value, decimalsOf(step))});
  }
}

void Axis::layLog(const AxisRange& range, int step) {
  const std::array<bool, 10>& marks = kDecadeMarks[static_cast<size_t>(std::max(0, 2 - step))];
  const int every = std::max(1, step - 1);
  const auto decadeOf = [](double value) {
    return std::clamp(static_cast<int>(std::floor(std::log10(value) + kSlack)), -kFarthestDecade, kFarthestDecade);
  };
  const int firstDecade = decadeOf(range.low);
  const int lastDecade = decadeOf(range.high) + 1;
  std::vector<AxisTick> all;
  for (int decade = firstDecade; decade <= lastDecade; ++decade) {
    for (int mantissa = 1; mantissa < 10; ++mantissa) {
      const double value = mantissa * std::pow(10, decade);
      const bool labelled = marks[static_cast<size_t>(mantissa)] && (decade - firstDecade) % every == 0;
      all.push_back({value, labelled ? decadeText(range, mantissa, decade) : ""});
    }
  }
  // Round ends are at 1, 2, 5 of a decade, not at the next of the few that are labelled.
  const auto roundEnd = [](const AxisTick& tick) {
    const auto mantissa = std::lround(tick.value / std::pow(10, std::floor(std::log10(tick.value) + kSlack)));
    return mantissa == 1 || mantissa == 2 || mantissa == 5;
  };
  low_ = range.low;
  high_ = range.high;
  if (range.roundLow) {
    for (const AxisTick& tick : all) {
      if (roundEnd(tick) && tick.value <= range.low * (1 + kSlack)) {
        low_ = tick.value;
      }
    }
  }
  if (range.roundHigh) {
    for (auto tick = all.rbegin(); tick != all.rend(); ++tick) {
      if (roundEnd(*tick) && tick->value >= range.high * (1 - kSlack)) {
        high_ = tick->value;
      }
    }
  }
  ticks_.clear();
  const double decades = std::log10(high_) - std::log10(low_);
  for (const AxisTick& tick : all) {
    const bool inside = tick.value >= low_ * (1 - kSlack) && tick.value <= high_ * (1 + kSlack);
    // Beyond a few decades, small ticks would be a grey bar.
    if (inside && (!tick.label.empty() || decades < 4)) {
      ticks_.push_back(tick);
    }
  }
}

bool Axis::fits(const std::function<double(const std::string&)>& labelLength) const {
  double end = -1e300;
  const double direction = to_ >= from_ ? 1 : -1;
  for (const AxisTick& tick : ticks_) {
    if (!tick.label.empty()) {
      const double middle = direction * at(tick.value);
      const double half = labelLength(tick.label) / 2;
      if (middle - half < end + kAxisLabelGap) {
        return false;
      }
      end = middle + half;
    }
  }
  return true;
}

double Axis::at(double value) const {
  const double held = std::clamp(value, low_, high_);
  // The ratio of far ends is no number, but that of their logarithms is.
  const auto scaled = [&](double each) { return scale_ == AxisScale::kLog ? std::log(each) : each; };
  const double share = (scaled(held) - scaled(low_)) / (scaled(high_) - scaled(low_));
  return from_ + (to_ - from_) * share;
}

bool Axis::holds(double value) const {
  const double slack = kSlack * (high_ - low_);
  return value >= low_ - slack && value <= high_ + slack;
}

std::string numberText(double value, int decimals) {
  if (!std::isfinite(value)) {
    return "\u2013";
  }
  std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  const size_t point = std::min(digits.find('.'), digits.size());
  for (size_t at = point; at > 3; at -= 3) {
    digits.insert(at - 3, 1, ',');
  }
  return value < 0 && !zero ? fmt::format("\u2212{}", digits) : digits;
}

std::string shortNumberText(double value) {
  if (!std::isfinite(value) || value == 0) {
    return numberText(value, 0);
  }
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return numberText(value, std::clamp(2 - magnitude, 0, 6));
}

std::string percentText(double share, int decimals) {
  const std::string number = numberText(100 * share, decimals);
  return std::isfinite(share) ? fmt::format("{}\u00a0%", number) : number;
}

}  // namespace ocelli
