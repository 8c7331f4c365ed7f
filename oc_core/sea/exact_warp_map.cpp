// exactWarpMap(): a ray for every pixel, one by one.
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "oc_core/sea/warp_map.h"

namespace ocelli {
namespace {

glm::vec2 exactPlace(const SeaProxy& proxy, const SeaCamera& target, const SeaCamera& reference,
                     const glm::vec2& pixel) {
  constexpr glm::vec2 kUnseen(std::numeric_limits<float>::quiet_NaN());
  const glm::vec3 eye(target.pose.position);
  const glm::vec3 referenceEye(reference.pose.position);
  const SeaProjection& projection = reference.projection;
  const glm::vec3 direction = glm::quat(target.pose.worldFromCamera) * target.projection.direction(pixel);
  const SightLine ray{eye, eye + direction * proxy.far()};
  float share = 0;
  proxy.rays().meet({&ray, 1}, {&share, 1});
  const glm::vec3 point = glm::mix(ray.from, ray.to, std::isinf(share) ? 1.0f : share);
  const SightLine back{referenceEye, glm::mix(point, referenceEye, kSightMargin)};
  uint8_t isBlocked = 0;
  proxy.blocked().find({&back, 1}, {&isBlocked, 1});
  const auto place = projection.pixel(glm::inverse(glm::quat(reference.pose.worldFromCamera)) * (point - referenceEye));
  if (isBlocked != 0 || !place) {
    return kUnseen;
  }
  const bool isInside = place->x >= 0 && place->y >= 0 && place->x <= static_cast<float>(projection.width) &&
                        place->y <= static_cast<float>(projection.height);
  return projection.wraps() || isInside ? *place : kUnseen;
}

}  // namespace

WarpMap exactWarpMap(const SeaProxy& proxy, const SeaCamera& target, const SeaCamera& reference) {
  WarpMap map(target.projection.width, target.projection.height);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      map(x, y) = exactPlace(proxy, target, reference, glm::vec2(x, y) + 0.5f);
    }
  }
  return map;
}

}  // namespace ocelli
