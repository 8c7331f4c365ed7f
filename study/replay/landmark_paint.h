// The colours of landmarks in drawings.
#pragma once

#include "oc_core/drawing/drawing.h"
#include "oc_core/image/color.h"
#include "oc_core/worlds/landmark_solids.h"

namespace ocelli {

inline Paint paintOf(LandmarkColor color) {
  const glm::vec3 linear = colorOf(color);
  return {static_cast<double>(srgbFromLinear(linear.x)), static_cast<double>(srgbFromLinear(linear.y)),
          static_cast<double>(srgbFromLinear(linear.z))};
}

}  // namespace ocelli
