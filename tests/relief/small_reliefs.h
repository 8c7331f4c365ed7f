// Small objects for relief tiles.
#pragma once

#include <memory>

#include "oc_core/base/random.h"
#include "oc_core/relief/relief_kinds.h"
#include "oc_core/relief/relief_picture.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/solids.h"

namespace ocelli::test {

/// A box around the origin, red.
inline Mesh redBox(const glm::vec3& half = {0.5f, 0.25f, 0.5f}) {
  Mesh box = makeBox(half);
  paint(box, {0.8f, 0.1f, 0.1f});
  return box;
}

/// A plate of half sides 0.5 between y = 0.3 and 0.4 over a leg of half sides 0.1 from y = -0.4 to 0.29.
inline Mesh table() {
  Mesh mesh;
  append(mesh, redBox({0.5f, 0.05f, 0.5f}), placedAt({0, 0.35f, 0}));
  Mesh leg = makeBox({0.1f, 0.345f, 0.1f});
  paint(leg, {0.1f, 0.1f, 0.8f});
  append(mesh, leg, placedAt({0, -0.055f, 0}));
  return mesh;
}

/// From `from` towards `to` and as far again.
inline StraightRay rayBetween(const glm::vec3& from, const glm::vec3& to) {
  return {from, (to - from) * 2.0f, 1};
}

inline glm::vec3 placeOn(const StraightRay& ray, const TriangleMeeting& meeting) {
  return ray.origin + ray.step * static_cast<float>(meeting.share);
}

/// From a sphere of radius 3 around the object into it.
inline StraightRay rayInto(Random& random) {
  const auto point = [&](float half) {
    return glm::vec3(random.inRange(-half, half), random.inRange(-half, half), random.inRange(-half, half));
  };
  glm::vec3 from = point(1);
  from = glm::normalize(from + glm::vec3(0, 0, 1e-3f)) * 3.0f;
  return rayBetween(from, point(0.5f));
}

inline std::shared_ptr<const ReliefScene> oneTile(const std::shared_ptr<const ReliefObject>& object,
                                                  const glm::mat4& worldFromTile = glm::mat4(1)) {
  return std::make_shared<const ReliefScene>(ReliefScene::Objects{object},
                                             std::vector<ReliefTile>{{0, worldFromTile, glm::vec3(1)}});
}

/// Over the ground by the angle, 4 away from the origin.
inline View viewFrom(double elevationDegrees, double azimuthDegrees = 30) {
  const double elevation = radiansFromDegrees(elevationDegrees);
  const double azimuth = radiansFromDegrees(azimuthDegrees);
  View view;
  view.eye = glm::vec3(glm::dvec3(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                                  std::cos(elevation) * std::cos(azimuth)) *
                       4.0);
  return view;
}

}  // namespace ocelli::test
