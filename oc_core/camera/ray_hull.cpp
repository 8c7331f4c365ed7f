#include "oc_core/camera/ray_hull.h"

namespace ocelli {

HullPieces hullOf(const PinholeCamera& camera, const glm::dvec2& lower, const glm::dvec2& upper) {
  HullPieces hull;
  for (const glm::dvec2& corner : {lower, glm::dvec2(upper.x, lower.y), upper, glm::dvec2(lower.x, upper.y)}) {
    for (const glm::vec3& point : camera.rayPath(glm::vec2(corner))) {
      hull.points.emplace_back(point);
    }
  }
  hull.endPiece();
  return hull;
}

}  // namespace ocelli
