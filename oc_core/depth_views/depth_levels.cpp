#include "oc_core/depth_views/depth_levels.h"

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

struct Ends {
  double first;  ///< of level 1
  double last;
};

Ends endsOf(const DepthLevels& levels) {
  const double a = levels.scale->scaleFromZ(levels.near);
  const double b = levels.scale->scaleFromZ(levels.far);
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

const std::array<DepthScale, 2>& depthScales() {
  static const std::array<DepthScale, 2> scales{{
      {"inverse_z", "equal steps of 1/z: level 1 is far, 65535 is near", [](float z) { return 1 / z; },
       [](float value) { return 1 / value; }},
      {"z", "equal steps of z: level 1 is near, 65535 is far", [](float z) { return z; },
       [](float value) { return value; }},
  }};
  return scales;
}

float DepthLevels::zOf(uint16_t level) const {
  if (level == 0) {
    return 0;
  }
  const Ends ends = endsOf(*this);
  const double value = ends.first + (ends.last - ends.first) * (level - 1) / (kMaxDepthLevel - 1);
  return std::clamp(scale->zFromScale(static_cast<float>(value)), near, far);
}

uint16_t DepthLevels::levelOf(float z) const {
  if (!(z > 0)) {
    return 0;
  }
  const Ends ends = endsOf(*this);
  const double share = (scale->scaleFromZ(std::clamp(z, near, far)) - ends.first) / (ends.last - ends.first);
  return static_cast<uint16_t>(std::clamp(std::lround(1 + share * (kMaxDepthLevel - 1)), 1L, long{kMaxDepthLevel}));
}

}  // namespace ocelli
