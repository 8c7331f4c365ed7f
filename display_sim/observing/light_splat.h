// Spreading the light of voxels over the pixels of an image.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

namespace ocelli {

/// Light of red, green and blue in units of 1 / kLightUnit. Whole numbers add up to the same in any order.
using FixedLight = std::array<uint64_t, 3>;
inline constexpr double kLightUnit = 1 << 24;

/// Adds up to the largest number at most, in any order: what does not fit is lost, but nothing wraps around.
inline void addLight(FixedLight& sum, const FixedLight& light) {
  for (size_t channel = 0; channel < sum.size(); ++channel) {
    sum[channel] += light[channel];
    sum[channel] = sum[channel] < light[channel] ? std::numeric_limits<uint64_t>::max() : sum[channel];
  }
}

/// How many images of this size, one for each thread, are worth their memory: a GiB in all, and one at least.
size_t lightImageCount(int width, int height, int threads);

class LightImage {
 public:
  LightImage(int width, int height)
      : width_(width), height_(height), pixels_(static_cast<size_t>(width) * static_cast<size_t>(height)) {}

  /// Adds `light` times `color`, spread evenly over the box of the given size around (u, v); what
  /// falls outside of the image is lost, and what has no place or size (NaN) too.
  void addBox(double u, double v, double boxWidth, double boxHeight, double light, const glm::dvec3& color);
  /// The same over an ellipse; what of it lies in a row of pixels is drawn as a box as high and as large.
  void addEllipse(double u, double v, double ellipseWidth, double ellipseHeight, double light, const glm::dvec3& color);

  const std::vector<FixedLight>& pixels() const { return pixels_; }

 private:
  /// To one row, which gets `light` in all, evenly from `left` to `right`.
  void addSpan(int row, double left, double right, double light, const glm::dvec3& color);

  int width_;
  int height_;
  std::vector<FixedLight> pixels_;
};

}  // namespace ocelli
