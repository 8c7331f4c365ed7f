#include "oc_core/scene/closed_parts.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

/// The triangles with vertices of equal position made one.
std::vector<glm::uvec3> weldedTriangles(const Mesh& mesh) {
  std::vector<uint32_t> weld(mesh.positions.size());
  meshopt_generateVertexRemap(weld.data(), nullptr, mesh.positions.size(), mesh.positions.data(), mesh.positions.size(),
                              sizeof(glm::vec3));
  std::vector<glm::uvec3> triangles(mesh.triangles.size());
  std::transform(mesh.triangles.begin(), mesh.triangles.end(), triangles.begin(),
                 [&](const glm::uvec3& t) { return glm::uvec3(weld[t.x], weld[t.y], weld[t.z]); });
  return triangles;
}

/// Disjoint sets of vertices.
class VertexSets {
 public:
  explicit VertexSets(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  uint32_t find(uint32_t vertex) {
    while (parent_[vertex] != vertex) {
      parent_[vertex] = parent_[parent_[vertex]];
      vertex = parent_[vertex];
    }
    return vertex;
  }
  void unite(uint32_t a, uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<uint32_t> parent_;
};

/// An edge as the vertex with the lower index lists it.
struct ListedEdge {
  uint32_t other;   ///< the vertex with the higher index
  int32_t forward;  ///< 1 where a triangle runs along it from the lower to the higher vertex, -1 where back
  uint32_t triangle;
  uint32_t corner;  ///< the edge runs from this corner of the triangle to the next one
};

/// Calls `onBorder(triangle, corner, times)` for the edges with more triangles along them in one direction than in the
/// other.
template <class OnBorder>
void forEachBorderEdge(const std::vector<glm::uvec3>& triangles, size_t vertexCount, const OnBorder& onBorder) {
  const auto forEachEdge = [&](const auto& body) {
    for (size_t i = 0; i < triangles.size(); ++i) {
      for (uint32_t corner = 0; corner < 3; ++corner) {
        const uint32_t from = triangles[i][static_cast<int>(corner)];
        const uint32_t to = triangles[i][static_cast<int>((corner + 1) % 3)];
        if (from != to) {
          body(std::min(from, to),
               ListedEdge{std::max(from, to), from < to ? 1 : -1, static_cast<uint32_t>(i), corner});
        }
      }
    }
  };
  std::vector<size_t> ends(vertexCount + 1);
  forEachEdge([&](uint32_t lower, const ListedEdge&) { ++ends[lower + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<ListedEdge> edges(ends.back());
  std::vector<size_t> next(ends.begin(), ends.end() - 1);
  forEachEdge([&](uint32_t lower, const ListedEdge& edge) { edges[next[lower]++] = edge; });

  for (size_t vertex = 0; vertex < vertexCount; ++vertex) {
    const auto last = edges.begin() + static_cast<std::ptrdiff_t>(ends[vertex + 1]);
    auto run = edges.begin() + static_cast<std::ptrdiff_t>(ends[vertex]);
    std::sort(run, last, [](const ListedEdge& a, const ListedEdge& b) {
      return a.other != b.other ? a.other < b.other : a.triangle < b.triangle;
    });
    while (run != last) {
      int32_t balance = 0;
      const ListedEdge& first = *run;
      for (; run != last && run->other == first.other; ++run) {
        balance += run->forward;
      }
      if (balance != 0) {
        onBorder(first.triangle, first.corner, std::abs(balance));
      }
    }
  }
}

struct Part {
  double area = 0;
  double volume = 0;  ///< six times the signed one
  double holes = 0;   ///< the most area that its borders could surround
};

}  // namespace

std::vector<Closure> closureOfTriangles(const Mesh& mesh, double largestHole) {
  if (mesh.empty()) {
    return {};
  }
  const std::vector<glm::uvec3> triangles = weldedTriangles(mesh);
  // Welding numbers the vertices anew and densely, so there are no more of them than before.
  const size_t vertexCount = mesh.positions.size();
  VertexSets sets(vertexCount);
  for (const glm::uvec3& t : triangles) {
    sets.unite(t.x, t.y);
    sets.unite(t.y, t.z);
  }

  std::vector<Part> parts(vertexCount);  // by the set's lowest vertex
  std::vector<glm::dvec3> origins(vertexCount, glm::dvec3(0));
  std::vector<bool> hasOrigin(vertexCount);
  const auto corner = [&](size_t triangle, uint32_t k) {
    return glm::dvec3(mesh.positions[mesh.triangles[triangle][static_cast<int>(k % 3)]]);
  };
  for (size_t i = 0; i < triangles.size(); ++i) {
    const uint32_t part = sets.find(triangles[i].x);
    if (!hasOrigin[part]) {
      hasOrigin[part] = true;
      origins[part] = corner(i, 0);
    }
    const glm::dvec3 a = corner(i, 0) - origins[part];
    const glm::dvec3 b = corner(i, 1) - origins[part];
    const glm::dvec3 c = corner(i, 2) - origins[part];
    parts[part].area += glm::length(glm::cross(b - a, c - a)) / 2;
    parts[part].volume += glm::dot(a, glm::cross(b, c));
  }
  // Borders are loops of edges. One of length L surrounds no more than a circle does: L^2 / 4 pi.
  struct BorderEdge {
    uint32_t vertex;
    double length;
  };
  std::vector<BorderEdge> border;
  VertexSets loops(vertexCount);
  forEachBorderEdge(triangles, vertexCount, [&](uint32_t triangle, uint32_t k, int32_t times) {
    const glm::uvec3& t = triangles[triangle];
    border.push_back({t[static_cast<int>(k)], times * glm::distance(corner(triangle, k), corner(triangle, k + 1))});
    loops.unite(t[static_cast<int>(k)], t[static_cast<int>((k + 1) % 3)]);
  });
  std::vector<double> loopLengths(vertexCount);
  for (const BorderEdge& edge : border) {
    loopLengths[loops.find(edge.vertex)] += edge.length;
  }
  for (size_t loop = 0; loop < vertexCount; ++loop) {
    parts[sets.find(static_cast<uint32_t>(loop))].holes += loopLengths[loop] * loopLengths[loop] / (4 * kPi);
  }

  std::vector<Closure> closures(triangles.size());
  for (size_t i = 0; i < triangles.size(); ++i) {
    const Part& part = parts[sets.find(triangles[i].x)];
    if (part.holes < largestHole * part.area && part.volume != 0) {
      closures[i] = part.volume > 0 ? Closure::kFacesOut : Closure::kFacesIn;
    }
  }
  return closures;
}

}  // namespace ocelli
