// What cameras share whose rays are straight.
#pragma once

#include "oc_core/camera/camera.h"
#include "oc_core/camera/view.h"

namespace ocelli {

inline bool isWithin(const View& view, double t) {
  return t >= static_cast<double>(view.zNear) && t <= static_cast<double>(view.zFar);
}

/// From t = `tMin` to `tMax`; empty where the pixel has no ray.
template <class C>
RayPath straightRay(const C& camera, const glm::vec2& pixel, float tMin, float tMax) {
  const std::optional<glm::vec3> from = camera.unproject({pixel.x, pixel.y, tMin});
  const std::optional<glm::vec3> to = camera.unproject({pixel.x, pixel.y, tMax});
  RayPath path;
  if (from && to) {
    path.add(*from, tMin);
    path.add(*to, tMax);
  }
  return path;
}
template <class C>
RayPath straightRay(const C& camera, const glm::vec2& pixel, const View& view) {
  return straightRay(camera, pixel, view.zNear, view.zFar);
}

}  // namespace ocelli
