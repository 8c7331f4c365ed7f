#include "oc_core/camera/distortion_map.h"

#include <glm/geometric.hpp>

namespace ocelli {

float DistortionMap::longestDisplacement() const {
  float longest = 0;  // squared
  for (const DistortionSample& sample : samples_) {
    longest = std::max(longest, glm::dot(sample.displacement, sample.displacement));
  }
  return std::sqrt(longest);
}

DistortionMap::Sloped DistortionMap::slopedAt(float u, float v) const {
  Sloped sloped{at(u, v), {}, {}};
  if (lookup_ == Lookup::kNearest) {
    return sloped;
  }
  const auto lastX = static_cast<float>(samples_.width() - 1);
  const auto lastY = static_cast<float>(samples_.height() - 1);
  const float x = std::clamp(u - 0.5f, 0.0f, lastX);
  const float y = std::clamp(v - 0.5f, 0.0f, lastY);
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, samples_.width() - 1);
  const int y1 = std::min(y0 + 1, samples_.height() - 1);
  const float fx = x - static_cast<float>(x0);
  const float fy = y - static_cast<float>(y0);
  using Four = float __attribute__((vector_size(16)));
  const auto four = [&](int column, int row) { return std::bit_cast<Four>(samples_(column, row)); };
  const Four a = four(x0, y0);
  const Four b = four(x1, y0);
  const Four c = four(x0, y1);
  const Four d = four(x1, y1);
  // Beyond the borders nothing changes.
  if (u - 0.5f == x) {
    sloped.alongU = std::bit_cast<DistortionSample>((b - a) * (1 - fy) + (d - c) * fy);
  }
  if (v - 0.5f == y) {
    sloped.alongV = std::bit_cast<DistortionSample>((c - a) * (1 - fx) + (d - b) * fx);
  }
  return sloped;
}

}  // namespace ocelli
