// What volumes look like along the rays of an image.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "oc_core/image/image.h"

namespace ocelli {

struct VolumePixel {
  static constexpr float kNowhere = std::numeric_limits<float>::infinity();

  glm::vec4 color{0};         ///< linear RGB, already multiplied by the opacity, and the opacity
  float t = kNowhere;         ///< the ray's parameter where its opacity first reaches VolumeRenderOptions::depthOpacity
  float surfaceT = kNowhere;  ///< the ray's parameter where it ends at an opaque surface
  uint32_t samples = 0;       ///< places where the field was looked at, for this pixel: what it cost

  /// The ray's parameter where it is opaque: in the volume, or at the surface that ends it.
  float opaqueT() const { return std::min(t, surfaceT); }

  bool operator==(const VolumePixel&) const = default;
};

using VolumeImage = Image<VolumePixel>;

/// The colour of a pixel before a background, linear RGB.
inline glm::vec3 colorBefore(const glm::vec3& background, const VolumePixel& pixel) {
  return glm::vec3(pixel.color) + background * (1 - pixel.color.w);
}

}  // namespace ocelli
