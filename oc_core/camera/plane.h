// A plane in the world, in double precision.
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace ocelli {

/// n . x = distance, with a unit normal.
struct Plane {
  glm::dvec3 normal{0, 0, 1};
  double distance = 0;

  static Plane through(const glm::dvec3& point, const glm::dvec3& normal) {
    const glm::dvec3 unit = glm::normalize(normal);
    return {unit, glm::dot(unit, point)};
  }
  /// Positive on the side that the normal points to.
  double height(const glm::dvec3& point) const { return glm::dot(normal, point) - distance; }
  /// Where the line through two points crosses it.
  glm::dvec3 crossing(const glm::dvec3& a, const glm::dvec3& b) const {
    const double heightA = height(a);
    const double heightB = height(b);
    return (b * heightA - a * heightB) / (heightA - heightB);
  }
};

/// The central projection from `viewpoint` onto `plane` in homogeneous coordinates (Appendix A). Weights are positive
/// beyond the plane where the viewpoint lies before it.
inline glm::dmat4 ontoPlane(const Plane& plane, const glm::dvec3& viewpoint) {
  const glm::dvec4 p(plane.normal, -plane.distance);
  const glm::dvec4 c(viewpoint, 1);
  return glm::outerProduct(c, p) - glm::dmat4(glm::dot(p, c));
}

}  // namespace ocelli
