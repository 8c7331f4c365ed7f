// Whether two neighbouring samples of a reference image lie on one surface: the criteria of image_mesh.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "oc_core/camera/camera.h"
#include "oc_core/ocri/image_mesh.h"

namespace ocelli {

/// Pixels between the undistorted places of two samples.
inline float undistortedDistance(const ImagePoint& a, const ImagePoint& b) {
  return glm::distance(glm::vec2(a.u, a.v), glm::vec2(b.u, b.v));
}

/// Undistorted samples, with the ones before a and after b in the same direction; z = 0 where there is none. They are
/// `evenSteps` where samples of a plane have equal steps of 1/z, however far apart they are undistorted. `spacing` is
/// what lies between neighbours on a surface that faces the pinhole, pixels.
inline bool samplesJoin(const ImagePoint& before, const ImagePoint& a, const ImagePoint& b, const ImagePoint& after,
                        bool evenSteps, float focalPixels, float spacing, const ImageMeshOptions& options) {
  /// Neighbours farther apart than this get no more tolerance of depth for it: a longer join is more likely to be a
  /// skin across a gap.
  constexpr float kLongestScaledStep = 1.5f;
  const float distance = undistortedDistance(a, b);
  if (!(a.z > 0) || !(b.z > 0) || !(distance <= options.longestStepPixels)) {
    return false;
  }
  const float footprint = std::min(a.z, b.z) / focalPixels * spacing;
  if (std::abs(a.z - b.z) <=
      options.depthStepFootprints * footprint * std::clamp(distance / spacing, 1.0f, kLongestScaledStep)) {
    return true;
  }
  // A grazing or a stretched surface: large steps of z, but 1/z goes on as on one of the two sides.
  const float tolerance = options.slopeToleranceFootprints * footprint / (a.z * b.z);
  const float step = 1 / b.z - 1 / a.z;
  const auto goesOn = [&](const ImagePoint& p, const ImagePoint& q) {
    if (!(p.z > 0) || !(q.z > 0)) {
      return false;
    }
    const float other = 1 / q.z - 1 / p.z;
    const float slope = other / std::max(undistortedDistance(p, q), 0.1f);
    return std::abs(step - slope * distance) <= tolerance || (evenSteps && std::abs(step - other) <= tolerance);
  };
  return goesOn(before, a) || goesOn(b, after);
}

}  // namespace ocelli
