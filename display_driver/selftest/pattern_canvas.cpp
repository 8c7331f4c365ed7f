#include "display_driver/selftest/pattern_canvas.h"

#include "oc_core/base/conventions.h"

namespace ocelli {

bool PatternGrid::holds(int sector, double radians) const {
  constexpr double kRounding = 1e-9;
  const double apart = std::remainder(radians - radiansOf(sector), 2 * kPi);
  return std::abs(apart) <= geometry_.stepRadians() / 2 + kRounding;
}

}  // namespace ocelli
