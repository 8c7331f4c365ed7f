// Some of the triangles of a mesh, ready to be drawn by cameras that share a reference pinhole.
#pragma once

#include <functional>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/camera/distorted_pinhole.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

struct TrianglePart {
  std::vector<glm::vec3> points;        ///< vertices, in the camera space of the reference pinhole
  std::vector<glm::uvec3> triangles;    ///< indices of `points`
  std::vector<uint32_t> meshTriangles;  ///< the index that each triangle has in the mesh
};

inline ImageBox boxAround(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
  return {glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
}

/// The triangles whose image, as `reference` sees it, lies in a box that `isWanted` holds for; it is called from
/// several threads. Those with a vertex that has no image are always among them. The triangles keep their order;
/// vertices that none of them names are dropped.
TrianglePart selectTriangles(const Mesh& mesh, const PinholeCamera& reference,
                             const std::function<bool(const ImageBox&)>& isWanted);

}  // namespace ocelli
