// Half spaces that bound what a part of a camera may show: they tell whether boxes lie within them, and clip triangles
// to them, in double precision.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "oc_core/camera/plane.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The points p with a . (p, 1) >= 0.
using HalfSpace = glm::dvec4;
using HalfSpaces = std::vector<HalfSpace>;

/// The side that the normal of a plane points to, and `margin` before it.
inline HalfSpace beyond(const Plane& plane, double margin = 0) {
  return {plane.normal, margin - plane.distance};
}
/// The other side, and `margin` beyond the plane.
inline HalfSpace before(const Plane& plane, double margin = 0) {
  return {-plane.normal, margin + plane.distance};
}
/// The points with a positive weight whose image lies within a convex polygon, clockwise as seen, widened by `margin`
/// pixels. Rows 0, 1 and 3 of the matrix give u, v and their weight.
HalfSpaces within(std::span<const glm::dvec2> polygon, const glm::dmat4& pixelFromWorld, double margin);

enum class Placement { kOutside, kAcross, kInside };
/// kOutside where one of the half spaces holds nothing of the box.
Placement placementOf(const Box& box, std::span<const HalfSpace> spaces);

/// A corner of a triangle that is clipped: its place, and the weights of the second and third vertex.
struct ClipCorner {
  glm::dvec3 p{0};
  glm::dvec2 b{0};
};

/// Keeps its memory from one triangle to the next.
class Clipper {
 public:
  /// What the half spaces leave of a triangle. Triangles that share an edge get the same points on it.
  const std::vector<ClipCorner>& clip(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                                      std::span<const HalfSpace> spaces);

 private:
  void clipTo(const HalfSpace& space);

  std::vector<ClipCorner> polygon_;
  std::vector<ClipCorner> scratch_;
};

}  // namespace ocelli
