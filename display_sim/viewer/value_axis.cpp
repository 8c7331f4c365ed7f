#include "display_sim/viewer/value_axis.h"

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

ValueAxis within(ValueAxis axis, const ValueAxis& whole) {
  const double width = std::min(axis.width(), whole.width());
  axis.least = std::clamp(axis.least, whole.least, whole.greatest - width);
  axis.greatest = axis.least + width;
  return axis;
}

}  // namespace

ValueAxis axisBetween(double least, double greatest) {
  if (greatest > least) {
    return {least, greatest};
  }
  const double around = std::max(std::abs(least) / 2, 0.5);
  return {least - around, least + around};
}

ValueAxis zoomedAxis(const ValueAxis& axis, const ValueAxis& whole, double value, double factor) {
  const double width = std::clamp(axis.width() / factor, kMinAxisShare * whole.width(), whole.width());
  const double share = axis.shareOf(value);
  const double least = value - share * width;
  return within({least, least + width}, whole);
}

ValueAxis pannedAxis(const ValueAxis& axis, const ValueAxis& whole, double share) {
  const double by = share * axis.width();
  return within({axis.least + by, axis.greatest + by}, whole);
}

double tickStep(const ValueAxis& axis, int count) {
  const double wanted = axis.width() / std::max(count, 1);
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * power >= wanted) {
      return digit * power;
    }
  }
  return 10 * power;
}

}  // namespace ocelli
