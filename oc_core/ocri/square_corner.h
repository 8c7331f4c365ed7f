// The corners of the squares that stand for samples at the rims of surfaces: what the meshers of image_mesh.h share.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>

#include "oc_core/camera/camera.h"
#include "oc_core/ocri/image_mesh.h"

namespace ocelli {

/// From a sample to the corners of its square, counter-clockwise, in halves of its sides: right and down.
inline constexpr std::array<glm::vec2, 4> kSquareSides{glm::vec2(-1, -1), glm::vec2(-1, 1), glm::vec2(1, 1),
                                                       glm::vec2(1, -1)};

/// `step` leads from a sample to the corner along its surface: pixels in u and v, and in z the change of 1/z. It is
/// shortened where it would reach deeper than the options allow.
inline ImagePoint squareCorner(const ImagePoint& sample, const ImagePoint& step, float focalPixels,
                               const ImageMeshOptions& options) {
  const float inverseZ = std::max(1 / sample.t + step.t, 0.5f / sample.t);
  const float depth = std::abs(1 / inverseZ - sample.t);
  const float most = options.deepestSquareFootprints * sample.t / focalPixels;
  if (depth <= most) {
    return {sample.u + step.u, sample.v + step.v, 1 / inverseZ};
  }
  const float part = most / depth;
  return {sample.u + part * step.u, sample.v + part * step.v, 1 / (1 / sample.t + part * (inverseZ - 1 / sample.t))};
}

}  // namespace ocelli
