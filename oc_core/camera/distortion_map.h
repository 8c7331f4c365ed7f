// The distortion map of the depth discontinuity occlusion camera (section 3.2.2): how far, which way and over which
// depths the rays of a reference pinhole camera are pushed, one sample for each of its pixels.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/vec2.hpp>

#include "oc_core/image/image.h"

namespace ocelli {

/// The five-tuple (dir_u, dir_v, z_n, z_f, d_f) of the text, with the direction scaled by d_f, and depths as 1/z
/// because the distortion is linear in 1/z.
struct DistortionSample {
  glm::vec2 displacement{0};  ///< (dir_u, dir_v) * d_f, pixels: the full displacement, reached at z_f
  float inverseNear = 0;      ///< 1/z_n: nearer points are not displaced
  float inverseFar = 0;       ///< 1/z_f: farther points are displaced in full

  /// Equation 3.3: the displacement at a depth, pixels.
  glm::vec2 at(float inverseZ) const {
    const float range = inverseNear - inverseFar;
    const float ramp = range > 0 ? std::clamp((inverseNear - inverseZ) / range, 0.0f, 1.0f) : 0.0f;
    return displacement * ramp;
  }
};

class DistortionMap {
 public:
  enum class Lookup {
    kNearest,   ///< the sample of the pixel, as in the text
    kBilinear,  ///< between the four nearest samples: a continuous field
  };

  DistortionMap() = default;
  DistortionMap(int width, int height, Lookup lookup) : samples_(width, height), lookup_(lookup) {}

  Image<DistortionSample>& samples() { return samples_; }
  const Image<DistortionSample>& samples() const { return samples_; }
  Lookup lookup() const { return lookup_; }

  /// The sample at undistorted image coordinates; beyond the borders the nearest one inside.
  DistortionSample at(float u, float v) const;
  /// The same, with how it changes for a pixel along u and v: within a cell between samples, bilinearly.
  struct Sloped {
    DistortionSample value;
    DistortionSample alongU;
    DistortionSample alongV;
  };
  Sloped slopedAt(float u, float v) const;
  /// The longest displacement in the map, pixels.
  float longestDisplacement() const;

 private:
  Image<DistortionSample> samples_;
  Lookup lookup_ = Lookup::kNearest;
};

inline DistortionSample DistortionMap::at(float u, float v) const {
  const auto lastX = static_cast<float>(samples_.width() - 1);
  const auto lastY = static_cast<float>(samples_.height() - 1);
  const float x = std::clamp(u - 0.5f, 0.0f, lastX);
  const float y = std::clamp(v - 0.5f, 0.0f, lastY);
  if (lookup_ == Lookup::kNearest) {
    return samples_(static_cast<int>(std::floor(x + 0.5f)), static_cast<int>(std::floor(y + 0.5f)));
  }
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, samples_.width() - 1);
  const int y1 = std::min(y0 + 1, samples_.height() - 1);
  const float fx = x - static_cast<float>(x0);
  const float fy = y - static_cast<float>(y0);
  const float w00 = (1 - fx) * (1 - fy);
  const float w10 = fx * (1 - fy);
  const float w01 = (1 - fx) * fy;
  const float w11 = fx * fy;
  // All four numbers of a sample at once.
  using Four = float __attribute__((vector_size(16)));
  static_assert(sizeof(DistortionSample) == sizeof(Four));
  const auto four = [&](int column, int row) { return std::bit_cast<Four>(samples_(column, row)); };
  return std::bit_cast<DistortionSample>(four(x0, y0) * w00 + four(x1, y0) * w10 + four(x0, y1) * w01 +
                                         four(x1, y1) * w11);
}

}  // namespace ocelli
