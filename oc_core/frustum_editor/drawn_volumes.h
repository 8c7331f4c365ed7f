// What rays fill and cross, as points: for drawn_camera.cpp alone.
#pragma once

#include <vector>

#include "oc_core/frustum_editor/drawn_camera.h"

namespace ocelli {

/// Where the rays at the corners of the part of frustum `i` cross its plane.
std::vector<glm::dvec3> crossingsOf(const GraphCamera& camera, int i);
/// The ray through the middle of its part: where it crosses the plane, and its direction behind it; unit.
struct DrawnRay {
  glm::dvec3 from{0};
  glm::dvec3 direction{0};
};
DrawnRay middleRayOf(const GraphCamera& camera, int i);

/// Of a convex polygon, what lies in the box; all of it where that is nothing.
std::vector<glm::dvec3> polygonWithin(std::vector<glm::dvec3> polygon, const Box& box);

/// The pieces of frustum `i` within the box. Those without a volume are left out.
std::vector<DrawnVolume> graphVolumesOf(const GraphCamera& camera, int i, const Box& room);
/// What two frusta both hold.
std::vector<DrawnVolume> commonVolumesOf(const GraphCamera& camera, int i, int j, const Box& room);
/// The corners of the pieces' faces that lie in a plane.
std::vector<glm::dvec3> cornersIn(const std::vector<DrawnVolume>& volumes, const Plane& plane, double slack);

/// What the rays of a curved ray camera pass within the box: of each part (ray_pieces.h).
std::vector<DrawnVolume> curvedVolumesOf(const CurvedRayCamera& camera, const Box& room);
/// Where rays at the border of the image meet the planes of a bend: from, middle and to.
std::array<std::vector<glm::dvec3>, 3> crossingsOfBend(const CurvedRayCamera& camera, size_t bend);

glm::dvec3 meanOf(const std::vector<glm::dvec3>& points);

}  // namespace ocelli
