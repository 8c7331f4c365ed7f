#include "oc_core/sea/hidden_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace ocelli {
namespace {

/// Below this share of the four samples around a place nothing is said of it.
constexpr float kMinWeight = 0.5f;

/// The color of a surface at a place of the I-node's image, in x to z, and in w how much of it is known.
glm::vec4 colorAt(const HiddenSamples& hidden, const SeaProjection& projection, const glm::vec2& place, float level) {
  const glm::vec2 corner = glm::floor(place - 0.5f);
  const glm::vec2 share = place - 0.5f - corner;
  glm::vec4 sum(0);
  for (int tap = 0; tap < 4; ++tap) {
    const glm::ivec2 step(tap & 1, tap >> 1);
    glm::ivec2 pixel = glm::ivec2(corner) + step;
    if (projection.wraps()) {
      pixel.x = (pixel.x + projection.width) % projection.width;
    }
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= projection.width || pixel.y >= projection.height) {
      continue;
    }
    // Of the layers the one whose surface is the nearest.
    float apart = HiddenSamples::kMaxLevelsApart;
    const Rgb8* color = nullptr;
    for (const HiddenLayer& layer : hidden.layers) {
      const uint16_t found = layer.level(pixel.x / HiddenSamples::kCell, pixel.y / HiddenSamples::kCell);
      const float distance = std::abs(static_cast<float>(found) - level);
      if (found != 0 && distance <= apart) {
        apart = distance;
        color = &layer.color(pixel.x, pixel.y);
      }
    }
    if (color != nullptr) {
      const float weight = (step.x == 1 ? share.x : 1 - share.x) * (step.y == 1 ? share.y : 1 - share.y);
      sum += weight * glm::vec4(glm::vec3(*color), 1);
    }
  }
  return sum.w >= kMinWeight ? sum / sum.w : glm::vec4(0);
}

bool isInside(const glm::vec2& place, const SeaProjection& projection) {
  return place.x >= 0 && place.y >= 0 && place.x <= static_cast<float>(projection.width) &&
         place.y <= static_cast<float>(projection.height);
}

}  // namespace

size_t HiddenSamples::cellCount() const {
  size_t count = 0;
  for (const HiddenLayer& layer : layers) {
    count += layer.level.size() - static_cast<size_t>(std::count(layer.level.begin(), layer.level.end(), 0));
  }
  return count;
}

float HiddenSamples::levelOf(float distance) const {
  return 1 + std::log(distance / nearest) / std::log1p(kLevelStep);
}

void addHidden(PartialImage& partial, const SeaProxy& proxy, const SeaCamera& target, const SeaCamera& inner,
               const HiddenSamples& hidden) {
  const glm::vec3 eye(target.pose.position);
  const glm::vec3 innerEye(inner.pose.position);
  const glm::mat3 worldFromTarget = glm::mat3_cast(target.pose.worldFromCamera);
  const glm::mat3 innerFromWorld = glm::mat3_cast(glm::inverse(inner.pose.worldFromCamera));
  std::vector<glm::ivec2> pixels;
  std::vector<SightLine> rays;
  for (int y = 0; y < partial.image.height(); ++y) {
    for (int x = 0; x < partial.image.width(); ++x) {
      if (partial.isKnown(x, y) == 0) {
        pixels.emplace_back(x, y);
        const glm::vec3 direction = worldFromTarget * target.projection.direction(glm::vec2(x, y) + 0.5f);
        rays.push_back({eye, eye + direction * proxy.far()});
      }
    }
  }
  std::vector<float> shares(rays.size());
  proxy.rays().meet(rays, shares);
  for (size_t i = 0; i < rays.size(); ++i) {
    if (std::isinf(shares[i])) {
      continue;
    }
    const glm::vec3 way = glm::mix(rays[i].from, rays[i].to, shares[i]) - innerEye;
    const float distance = glm::length(way);
    const auto place = inner.projection.pixel(innerFromWorld * way);
    if (!place || !(distance > 0) || !isInside(*place, inner.projection)) {
      continue;
    }
    const glm::vec4 color = colorAt(hidden, inner.projection, *place, hidden.levelOf(distance));
    if (color.w > 0) {
      partial.image(pixels[i].x, pixels[i].y) = Rgb8(glm::vec3(color) + 0.5f);
      partial.isKnown(pixels[i].x, pixels[i].y) = 1;
    }
  }
}

}  // namespace ocelli
