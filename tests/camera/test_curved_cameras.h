// Curved ray cameras for tests: of the small camera's view from (0, 0, 10) towards the origin.
#pragma once

#include "oc_core/camera/curved_ray_camera.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli::test {

/// Planes through the line through `point` along `line`, from one normal by way of another to the last.
inline TransitionPlanes planesThrough(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& middle,
                                      const glm::dvec3& to) {
  return {Plane::through(point, from), Plane::through(point, middle), Plane::through(point, to)};
}

/// A turn to the right around a vertical line.
inline TransitionPlanes rightTurn() {
  return planesThrough({4, 0, 0}, {-0.25, 0, -1}, {0, 0, -1}, {0.25, 0, -1});
}
inline CurvedRayCamera bendingRight(const PinholeCamera& camera = smallCamera(), ArcModel model = ArcModel::kConic) {
  CurvedRayCamera curved(camera, model);
  curved.bend(rightTurn(), {-2, 0, 6});
  return curved;
}

/// And then upwards, around a horizontal line.
inline CurvedRayCamera bendingTwice(const PinholeCamera& camera = smallCamera(), ArcModel model = ArcModel::kConic) {
  CurvedRayCamera curved = bendingRight(camera, model);
  curved.bend(planesThrough({0, 6, -4}, {0, -0.2, -1}, {0, 0, -1}, {0, 0.2, -1}), {-0.5, -1.5, 1});
  return curved;
}

}  // namespace ocelli::test
