#include "oc_core/scene/closed_parts.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <atomic>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/disjoint_sets.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// `times` more triangles run along it in this direction than in the other.
struct BorderEdge {
  uint32_t from, to;
  int32_t times;
};

/// The edges that are left over when those of opposite direction cancel, by their vertices.
std::vector<BorderEdge> unmatched(std::vector<BorderEdge> edges) {
  for (BorderEdge& edge : edges) {
    if (edge.from > edge.to) {
      edge = {edge.to, edge.from, -edge.times};
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const BorderEdge& a, const BorderEdge& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
  std::vector<BorderEdge> left;
  for (auto edge = edges.begin(); edge != edges.end();) {
    BorderEdge sum{edge->from, edge->to, 0};
    for (; edge != edges.end() && edge->from == sum.from && edge->to == sum.to; ++edge) {
      sum.times += edge->times;
    }
    if (sum.times > 0) {
      left.push_back(sum);
    } else if (sum.times < 0) {
      left.push_back({sum.to, sum.from, -sum.times});
    }
  }
  return left;
}

uint64_t mixed(uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

template <class Body>
void forEachEdge(const glm::uvec3& t, const Body& body) {
  for (int corner = 0; corner < 3; ++corner) {
    if (t[corner] != t[(corner + 1) % 3]) {
      body(t[corner], t[(corner + 1) % 3]);
    }
  }
}

/// The unmatched edges of the triangles as they are. Nearly all edges of a scan match: those are found by sums that
/// cancel, one a vertex, over its edges to higher vertices; the few others are sorted.
std::vector<BorderEdge> unmatchedEdges(const Mesh& mesh) {
  std::vector<uint64_t> sums(mesh.positions.size());
  parallelFor(mesh.triangles.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      forEachEdge(mesh.triangles[i], [&](uint32_t from, uint32_t to) {
        const uint64_t term = mixed(uint64_t{std::max(from, to)} + 1);
        std::atomic_ref(sums[std::min(from, to)]).fetch_add(from < to ? term : ~term + 1, std::memory_order_relaxed);
      });
    }
  });
  std::vector<BorderEdge> edges;
  for (const glm::uvec3& t : mesh.triangles) {
    forEachEdge(t, [&](uint32_t from, uint32_t to) {
      if (sums[std::min(from, to)] != 0) {
        edges.push_back({from, to, 1});
      }
    });
  }
  return unmatched(std::move(edges));
}

/// Joins the vertices of the edges that lie at the same place: each edge names the first of them. Adds them to the same
/// set.
void weld(std::vector<BorderEdge>& edges, const Mesh& mesh, DisjointSets& sets) {
  if (edges.empty()) {
    return;
  }
  std::vector<uint32_t> vertices;
  for (const BorderEdge& edge : edges) {
    vertices.push_back(edge.from);
    vertices.push_back(edge.to);
  }
  std::vector<glm::vec3> positions(vertices.size());
  std::transform(vertices.begin(), vertices.end(), positions.begin(), [&](uint32_t v) { return mesh.positions[v]; });
  std::vector<uint32_t> places(vertices.size());
  meshopt_generateVertexRemap(places.data(), nullptr, positions.size(), positions.data(), positions.size(),
                              sizeof(glm::vec3));
  std::vector<uint32_t> first(
      vertices.size());  // of each place; places are numbered in the order of their first vertex
  uint32_t known = 0;
  for (size_t i = 0; i < vertices.size(); ++i) {
    if (places[i] == known) {
      first[known++] = vertices[i];
    }
    sets.join(first[places[i]], vertices[i]);
  }
  for (size_t i = 0; i < edges.size(); ++i) {
    edges[i].from = first[places[2 * i]];
    edges[i].to = first[places[2 * i + 1]];
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
  const size_t vertexCount = mesh.positions.size();
  DisjointSets sets(vertexCount);
  for (const glm::uvec3& t : mesh.triangles) {
    sets.join(t.x, t.y);
    sets.join(t.y, t.z);
  }
  std::vector<BorderEdge> border = unmatchedEdges(mesh);
  weld(border, mesh, sets);
  border = unmatched(std::move(border));
  sets.flatten();

  std::vector<Part> parts(vertexCount);  // by the set's lowest vertex
  for (const glm::uvec3& t : mesh.triangles) {
    const uint32_t part = sets.least(t.x);
    const glm::dvec3 origin(mesh.positions[part]);
    const glm::dvec3 a = glm::dvec3(mesh.positions[t.x]) - origin;
    const glm::dvec3 b = glm::dvec3(mesh.positions[t.y]) - origin;
    const glm::dvec3 c = glm::dvec3(mesh.positions[t.z]) - origin;
    parts[part].area += glm::length(glm::cross(b - a, c - a)) / 2;
    parts[part].volume += glm::dot(a, glm::cross(b, c));
  }
  // Borders are loops of edges. One of length L surrounds no more than a circle does: L^2 / 4 pi.
  DisjointSets loops(vertexCount);
  for (const BorderEdge& edge : border) {
    loops.join(edge.from, edge.to);
  }
  std::vector<double> loopLengths(vertexCount);
  for (const BorderEdge& edge : border) {
    loopLengths[loops.least(edge.from)] +=
        edge.times * glm::distance(glm::dvec3(mesh.positions[edge.from]), glm::dvec3(mesh.positions[edge.to]));
  }
  for (size_t loop = 0; loop < vertexCount; ++loop) {
    if (loopLengths[loop] > 0) {
      parts[sets.least(static_cast<uint32_t>(loop))].holes += loopLengths[loop] * loopLengths[loop] / (4 * kPi);
    }
  }

  std::vector<Closure> closures(mesh.triangles.size());
  for (size_t i = 0; i < closures.size(); ++i) {
    const Part& part = parts[sets.least(mesh.triangles[i].x)];
    if (part.holes < largestHole * part.area && part.volume != 0) {
      closures[i] = part.volume > 0 ? Closure::kFacesOut : Closure::kFacesIn;
    }
  }
  return closures;
}

}  // namespace ocelli
