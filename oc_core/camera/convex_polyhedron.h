// A convex polyhedron, as the polygons of its faces: a box that planes cut.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/camera/plane.h"

namespace ocelli {

class ConvexPolyhedron {
 public:
  /// The box between two corners, of which no coordinate of `lower` exceeds that of `upper`. It may be flat.
  ConvexPolyhedron(const glm::dvec3& lower, const glm::dvec3& upper);

  /// Keeps what is not on the side of the plane that the normal points to.
  void cut(const Plane& plane);

  bool empty() const { return faces_.empty(); }
  /// The corners of each face, one way round.
  const std::vector<std::vector<glm::dvec3>>& faces() const { return faces_; }
  /// The corners of its bounding box; it must not be empty.
  const glm::dvec3& lower() const { return lower_; }
  const glm::dvec3& upper() const { return upper_; }
  /// The mean of its faces' corners, a point within; it must not be empty.
  glm::dvec3 middle() const;

 private:
  using Face = std::vector<glm::dvec3>;  ///< its corners, one way round

  void updateBounds();

  std::vector<Face> faces_;
  glm::dvec3 lower_;
  glm::dvec3 upper_;
};

}  // namespace ocelli
