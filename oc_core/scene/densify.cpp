#include "oc_core/scene/densify.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

namespace ocelli {
namespace {

constexpr uint32_t kNotSplit = 0xffffffffu;

struct Edge {
  uint32_t low = 0;   ///< the lesser vertex index
  uint32_t high = 0;  ///< the greater one
  uint32_t triangles = 0;
};

struct Edges {
  std::vector<Edge> edges;
  std::vector<glm::uvec3> ofTriangle;  ///< edge i runs from corner i to corner i + 1
};

/// Numbers the edges in the order in which the triangles name them.
Edges findEdges(const Mesh& mesh) {
  constexpr uint32_t kEnd = 0xffffffffu;
  Edges found;
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

void splitEdges(Mesh& mesh, const Edges& found, const std::vector<uint32_t>& chosen) {
  std::vector<uint32_t> middle(found.edges.size(), kNotSplit);
  mesh.positions.reserve(mesh.positions.size() + chosen.size());
  if (!mesh.colors.empty()) {
    mesh.colors.reserve(mesh.colors.size() + chosen.size());
  }
  for (const uint32_t edge : chosen) {
    const auto [low, high, triangles] = found.edges[edge];
    middle[edge] = static_cast<uint32_t>(mesh.positions.size());
    mesh.positions.push_back(mesh.positions[low] * 0.5f + mesh.positions[high] * 0.5f);
    if (!mesh.colors.empty()) {
      mesh.colors.push_back((mesh.colors[low] + mesh.colors[high]) * 0.5f);
    }
  }
  std::vector<glm::uvec3> parts;
  parts.reserve(mesh.triangles.size() + 2 * chosen.size());
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& edges = found.ofTriangle[i];
    addParts(parts, mesh, mesh.triangles[i], {middle[edges.x], middle[edges.y], middle[edges.z]});
  }
  mesh.triangles = std::move(parts);
}

}  // namespace

void densify(Mesh& mesh, size_t triangles) {
  while (!mesh.empty() && mesh.triangles.size() < triangles) {
    const Edges found = findEdges(mesh);
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
