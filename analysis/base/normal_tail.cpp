#include "analysis/base/normal_tail.h"

#include <cmath>
#include <numbers>

namespace ocelli {
namespace {

/// From here on P(Z > z) is taken from its series.
constexpr double kFarTail = 30;

/// P(Z > z) z / density: Abramowitz and Stegun 26.2.12. The first term left out is below 1e-9 of the sum's last digit.
double farTailFactor(double z) {
  const double y = 1 / (z * z);
  return 1 - y * (1 - 3 * y * (1 - 5 * y * (1 - 7 * y)));
}

double nearTail(double z) {
  return std::erfc(z / std::numbers::sqrt2) / 2;
}

}  // namespace

double logNormalTail(double z) {
  if (z < kFarTail) {
    return std::log(nearTail(z));
  }
  return -z * z / 2 - std::log(z) - std::log(2 * std::numbers::pi) / 2 + std::log(farTailFactor(z));
}

double normalHazard(double z) {
  if (z < kFarTail) {
    return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi) / nearTail(z);
  }
  return z / farTailFactor(z);
}

}  // namespace ocelli
