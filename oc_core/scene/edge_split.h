// Splitting triangles at the midpoints of chosen edges, without opening cracks.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

struct Edge {
  uint32_t low = 0;   ///< the lesser vertex index
  uint32_t high = 0;  ///< the greater one
  uint32_t triangles = 0;
};

struct EdgeList {
  std::vector<Edge> edges;
  std::vector<glm::uvec3> ofTriangle;  ///< edge i of a triangle runs from its corner i to corner i + 1
};

/// The edges of `mesh`, in the order in which its triangles name them.
EdgeList findEdges(const Mesh& mesh);

/// Splits each of the `chosen` edges (indices into `list`, which findEdges(mesh) made). Vertex i of the new ones, which
/// stand at the end, is the middle of edge chosen[i]; colours are interpolated. Triangles become two, three or four.
void splitEdges(Mesh& mesh, const EdgeList& list, const std::vector<uint32_t>& chosen);

}  // namespace ocelli
