#include "oc_core/camera/gpc_profile.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace ocelli {
namespace {

constexpr int kMaxNewtonSteps = 100;  ///< only guards against numbers gone wrong: halving a bracket takes 60

std::array<double, 4> linear(double zoom, double outer) {
  return {1 / zoom, (outer - 1 / zoom) / (outer - 1), 0, 0};
}

std::array<double, 4> quadratic(double zoom, double outer) {
  const double width = outer - 1;
  return {1 / zoom, 1 / zoom, outer * (1 - 1 / zoom) / (width * width), 0};
}

std::array<double, 4> cubic(double zoom, double outer) {
  const double width = outer - 1;
  const double inner = 1 / zoom;  // both f and f' at the inner edge
  const double mean = (outer - inner) / width;
  return {inner, inner, (3 * mean - 2 * inner - 1) / width, (inner + 1 - 2 * mean) / (width * width)};
}

constexpr std::array<GpcSampling, 3> kSamplings{
    {{"linear", "a constant rate across the transition, the highest least rate there is, which jumps at both edges",
      linear},
     {"quadratic", "no jump of the rate at the inner edge", quadratic},
     {"cubic", "no jump of the rate at either edge", cubic}}};

}  // namespace

std::span<const GpcSampling> gpcSamplings() {
  return kSamplings;
}

const GpcSampling* findGpcSampling(const char* name) {
  const auto* found = std::find_if(kSamplings.begin(), kSamplings.end(),
                                   [&](const GpcSampling& each) { return std::string_view(each.name) == name; });
  return found == kSamplings.end() ? nullptr : found;
}

double highestLeastRate(double zoom, double outer) {
  return (outer - 1) / (outer - 1 / zoom);
}

GpcProfile::GpcProfile(const GpcSampling& sampling, double zoom, double outer)
    : zoom_(zoom), outer_(outer), c_(sampling.coefficients(zoom, outer)) {
  const double width = outer - 1;
  const double inside = 1 / zoom;
  leastSlope_ = std::min({inside, 1.0, slope(1), slope(outer)});
  greatestSlope_ = std::max({inside, 1.0, slope(1), slope(outer)});
  longestShift_ = std::abs(1 - 1 / zoom);
  const auto isWithin = [&](double s) { return s > 0 && s < width; };
  if (c_[3] != 0) {
    const double vertex = -c_[2] / (3 * c_[3]);
    if (isWithin(vertex)) {
      leastSlope_ = std::min(leastSlope_, slope(1 + vertex));
      greatestSlope_ = std::max(greatestSlope_, slope(1 + vertex));
    }
  }
  // r - f(r) is greatest at the inner edge, or where f' = 1: 3 c3 s^2 + 2 c2 s + c1 - 1 = 0.
  const auto consider = [&](double s) {
    if (isWithin(s)) {
      longestShift_ = std::max(longestShift_, std::abs(1 + s - polynomial(s)));
    }
  };
  const double root = c_[2] * c_[2] - 3 * c_[3] * (c_[1] - 1);
  if (root >= 0 && (c_[2] != 0 || root > 0)) {
    const double q = -(c_[2] + std::copysign(std::sqrt(root), c_[2]));
    consider(c_[3] != 0 ? q / (3 * c_[3]) : -1);
    consider((c_[1] - 1) / q);
  }
  if (c_[3] != 0 && isIncreasing()) {
    std::array<double, kTableSteps + 1> table{};
    for (size_t i = 1; i < kTableSteps; ++i) {
      table[i] = inverseOfCubic(c_[0] + (outer - c_[0]) * static_cast<double>(i) / kTableSteps) - 1;
    }
    table[kTableSteps] = width;
    table_ = table;
  }
}

double GpcProfile::inverse(double f) const {
  if (f <= 1 / zoom_) {
    return f * zoom_;
  }
  if (f >= outer_) {
    return f;
  }
  if (c_[3] != 0) {
    return inverseOfCubic(f);
  }
  // The root that grows with f, without the difference of like numbers; c2 may be 0.
  const double over = f - c_[0];
  const double s = 2 * over / (c_[1] + std::sqrt(std::max(c_[1] * c_[1] + 4 * c_[2] * over, 0.0)));
  return std::min(1 + s, outer_);
}

double GpcProfile::inverseOfCubic(double f) const {
  const double width = outer_ - 1;
  const double at = (f - c_[0]) / (outer_ - c_[0]) * kTableSteps;
  const auto step = static_cast<size_t>(std::clamp(at, 0.0, kTableSteps - 1.0));
  const bool isFilled = table_[kTableSteps] > 0;
  double lower = isFilled ? table_[step] : 0;
  double upper = isFilled ? table_[step + 1] : width;
  double s = lower + (upper - lower) * (isFilled ? at - static_cast<double>(step) : at / kTableSteps);
  for (int i = 0; i < kMaxNewtonSteps; ++i) {
    const double error = polynomial(s) - f;
    (error > 0 ? upper : lower) = s;
    double next = s - error / slope(1 + s);
    if (!(next >= lower && next <= upper)) {
      next = (lower + upper) / 2;
    }
    if (std::abs(next - s) <= 1e-14 * outer_) {
      return 1 + next;
    }
    s = next;
  }
  return 1 + s;
}

}  // namespace ocelli
