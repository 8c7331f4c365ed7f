// Depth as the length of a ray: of cameras that look in all directions, and of any camera whose rays bend.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/base/conventions.h"
#include "oc_core/camera/camera.h"
#include "oc_core/camera/view.h"

namespace ocelli {

inline bool isWithin(const View& view, double length) {
  return length >= static_cast<double>(view.zNear) && length <= static_cast<double>(view.zFar);
}

/// From zNear to zFar, for a camera whose rays are straight and whose z is their length.
template <class C>
RayPath straightRay(const C& camera, const glm::vec2& pixel) {
  const std::optional<glm::vec3> from = camera.unproject({pixel.x, pixel.y, camera.view().zNear});
  const std::optional<glm::vec3> to = camera.unproject({pixel.x, pixel.y, camera.view().zFar});
  return from && to ? RayPath{*from, *to} : RayPath{};
}

/// A point beside a ray: how far along it, from its first point, the foot of the perpendicular lies, and which way the
/// ray goes there (a unit vector).
struct PlaceOnRay {
  float length = 0;
  glm::vec3 direction{0};
};
inline PlaceOnRay placeOnRay(const RayPath& path, const glm::vec3& point) {
  PlaceOnRay best;
  float least = std::numeric_limits<float>::max();
  float before = 0;
  for (size_t i = 1; i < path.size(); ++i) {
    const glm::vec3 step = path[i] - path[i - 1];
    const float length = glm::length(step);
    if (!(length > 0)) {
      continue;
    }
    const glm::vec3 direction = step / length;
    const float along = std::clamp(glm::dot(point - path[i - 1], direction), 0.0f, length);
    const float beside = glm::distance(path[i - 1] + direction * along, point);
    if (beside < least) {
      least = beside;
      best = {before + along, direction};
    }
    before += length;
  }
  return best;
}

}  // namespace ocelli
