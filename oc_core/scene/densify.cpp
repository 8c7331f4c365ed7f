#include "oc_core/scene/densify.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "oc_core/scene/edge_split.h"

namespace ocelli {
namespace {

/// The edges to split so that about `more` triangles are added: each split adds one to each triangle at the edge.
std::vector<uint32_t> longestEdges(const Mesh& mesh, const std::vector<Edge>& edges, size_t more) {
  std::vector<uint32_t> order(edges.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<float> length2(edges.size());
  for (size_t i = 0; i < edges.size(); ++i) {
    const glm::vec3 along = mesh.positions[edges[i].high] - mesh.positions[edges[i].low];
    length2[i] = glm::dot(along, along);
  }
  std::sort(order.begin(), order.end(),
            [&](uint32_t a, uint32_t b) { return length2[a] != length2[b] ? length2[a] > length2[b] : a < b; });
  size_t added = 0;
  size_t count = 0;
  while (count < order.size() && added < more) {
    added += edges[order[count++]].triangles;
  }
  order.resize(count);
  return order;
}

}  // namespace

void densify(Mesh& mesh, size_t triangles) {
  while (!mesh.empty() && mesh.triangles.size() < triangles) {
    const EdgeList found = findEdges(mesh);
    if (mesh.triangles.size() * 4 <= triangles) {
      std::vector<uint32_t> all(found.edges.size());
      std::iota(all.begin(), all.end(), 0u);
      splitEdges(mesh, found, all);
    } else {
      splitEdges(mesh, found, longestEdges(mesh, found.edges, triangles - mesh.triangles.size()));
    }
  }
}

}  // namespace ocelli
