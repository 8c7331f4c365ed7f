#include "oc_core/scene/edge_split.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace ocelli {
namespace {

constexpr uint32_t kNotSplit = 0xffffffffu;

/// The triangles that replace one with corners `t`, where `middle[i]` is the vertex on edge i or kNotSplit.
void addParts(std::vector<glm::uvec3>& parts, const Mesh& mesh, const glm::uvec3& t, const glm::uvec3& middle) {
  const auto isSplit = [&](glm::length_t i) { return middle[i] != kNotSplit; };
  const int splits = isSplit(0) + isSplit(1) + isSplit(2);
  if (splits == 0) {
    parts.push_back(t);
    return;
  }
  if (splits == 3) {
    parts.push_back({t.x, middle.x, middle.z});
    parts.push_back({middle.x, t.y, middle.y});
    parts.push_back({middle.z, middle.y, t.z});
    parts.push_back(middle);
    return;
  }
  // Turn the triangle so that its one split edge, or the first of its two, runs from a to b.
  glm::length_t first = 0;
  while (!(isSplit(first) && (splits == 1 || isSplit((first + 1) % 3)))) {
    ++first;
  }
  const uint32_t a = t[first];
  const uint32_t b = t[(first + 1) % 3];
  const uint32_t c = t[(first + 2) % 3];
  const uint32_t ab = middle[first];
  if (splits == 1) {
    parts.push_back({a, ab, c});
    parts.push_back({ab, b, c});
    return;
  }
  const uint32_t bc = middle[(first + 1) % 3];
  parts.push_back({ab, b, bc});
  // The quad a, ab, bc, c falls along its shorter diagonal.
  const glm::vec3 fromA = mesh.positions[bc] - mesh.positions[a];
  const glm::vec3 fromC = mesh.positions[ab] - mesh.positions[c];
  if (glm::dot(fromA, fromA) <= glm::dot(fromC, fromC)) {
    parts.push_back({a, ab, bc});
    parts.push_back({a, bc, c});
  } else {
    parts.push_back({a, ab, c});
    parts.push_back({ab, bc, c});
  }
}

}  // namespace

EdgeList findEdges(const Mesh& mesh) {
  constexpr uint32_t kEnd = 0xffffffffu;
  EdgeList found;
  found.edges.reserve(mesh.triangles.size() * 3 / 2);
  found.ofTriangle.resize(mesh.triangles.size());
  std::vector<uint32_t> firstAtLow(mesh.positions.size(),
                                   kEnd);  // heads of the lists of edges with the same low vertex
  std::vector<uint32_t> nextAtLow;
  nextAtLow.reserve(found.edges.capacity());
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    for (glm::length_t corner = 0; corner < 3; ++corner) {
      const auto [low, high] = std::minmax(t[corner], t[(corner + 1) % 3]);
      uint32_t edge = firstAtLow[low];
      while (edge != kEnd && found.edges[edge].high != high) {
        edge = nextAtLow[edge];
      }
      if (edge == kEnd) {
        edge = static_cast<uint32_t>(found.edges.size());
        found.edges.push_back({low, high, 0});
        nextAtLow.push_back(firstAtLow[low]);
        firstAtLow[low] = edge;
      }
      ++found.edges[edge].triangles;
      found.ofTriangle[i][corner] = edge;
    }
  }
  return found;
}

void splitEdges(Mesh& mesh, const EdgeList& list, const std::vector<uint32_t>& chosen) {
  std::vector<uint32_t> middle(list.edges.size(), kNotSplit);
  mesh.positions.reserve(mesh.positions.size() + chosen.size());
  if (!mesh.colors.empty()) {
    mesh.colors.reserve(mesh.colors.size() + chosen.size());
  }
  for (const uint32_t edge : chosen) {
    const auto [low, high, triangles] = list.edges[edge];
    middle[edge] = static_cast<uint32_t>(mesh.positions.size());
    mesh.positions.push_back(mesh.positions[low] * 0.5f + mesh.positions[high] * 0.5f);
    if (!mesh.colors.empty()) {
      mesh.colors.push_back((mesh.colors[low] + mesh.colors[high]) * 0.5f);
    }
  }
  std::vector<glm::uvec3> parts;
  parts.reserve(mesh.triangles.size() + 2 * chosen.size());
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& edges = list.ofTriangle[i];
    addParts(parts, mesh, mesh.triangles[i], {middle[edges.x], middle[edges.y], middle[edges.z]});
  }
  mesh.triangles = std::move(parts);
}

}  // namespace ocelli
