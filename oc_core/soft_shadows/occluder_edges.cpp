#include "oc_core/soft_shadows/occluder_edges.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "oc_core/base/disjoint_sets.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// Triangles begin so far in front of the light, world units.
constexpr float kInFront = 1e-5f;
/// Two triangles lie in one plane where the sine of the angle between them is less: what single precision tells.
constexpr float kSinFlat = 1e-6f;

/// The part of a triangle in front of the light, as a fan.
void addCut(Mesh& mesh, const std::array<glm::vec3, 3>& corners) {
  std::vector<glm::vec3> kept;
  for (size_t i = 0; i < 3; ++i) {
    const glm::vec3& p = corners[i];
    const glm::vec3& q = corners[(i + 1) % 3];
    if (p.z >= kInFront) {
      kept.push_back(p);
    }
    if ((p.z >= kInFront) != (q.z >= kInFront)) {
      // The same for both triangles of an edge.
      const bool inOrder = p.z < q.z;
      const glm::vec3& low = inOrder ? p : q;
      const glm::vec3& high = inOrder ? q : p;
      glm::vec3 cut = low + (high - low) * ((kInFront - low.z) / (high.z - low.z));
      cut.z = kInFront;
      kept.push_back(cut);
    }
  }
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), kept.begin(), kept.end());
  for (uint32_t i = 2; i < kept.size(); ++i) {
    mesh.triangles.push_back({first, first + i - 1, first + i});
  }
}

Mesh inFrontOf(const LightFrame& frame, const Mesh& occluders) {
  Mesh mesh;
  mesh.positions.resize(occluders.positions.size());
  parallelFor(mesh.positions.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      mesh.positions[i] = frame.fromWorld(occluders.positions[i]);
    }
  });
  mesh.triangles.reserve(occluders.triangles.size());
  for (const glm::uvec3& t : occluders.triangles) {
    const std::array<glm::vec3, 3> corners{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
    const int inFront = (corners[0].z >= kInFront) + (corners[1].z >= kInFront) + (corners[2].z >= kInFront);
    if (inFront == 3) {
      mesh.triangles.push_back(t);
    } else if (inFront > 0) {
      addCut(mesh, corners);
    }
  }
  return mesh;
}

/// One side of a triangle.
struct Side {
  uint32_t to = 0;  ///< the vertex with the higher number
  uint32_t triangle = 0;
  bool ascends = true;  ///< whether it runs from the vertex with the lower number
};

}  // namespace

int weightOf(const OccluderEdge& edge, const std::vector<glm::vec4>& planes, const glm::vec3& point) {
  const int own = sideOf(planes[edge.plane], point) >= 0 ? 1 : -1;
  const int other = edge.otherSign == 0 ? 0 : sideOf(planes[edge.other], point) >= 0 ? 1 : -1;
  return own + other * edge.otherSign;
}

OccluderEdges occluderEdges(const Mesh& occluders, const LightFrame& frame) {
  OccluderEdges result;
  result.mesh = inFrontOf(frame, occluders);
  const std::vector<glm::vec3>& positions = result.mesh.positions;
  // Planes; triangles without an area hide nothing.
  result.planes.resize(result.mesh.triangles.size());
  parallelFor(result.planes.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::uvec3& t = result.mesh.triangles[i];
      const glm::dvec3 a(positions[t.x]);
      const glm::dvec3 normal = glm::cross(glm::dvec3(positions[t.y]) - a, glm::dvec3(positions[t.z]) - a);
      const double length = glm::length(normal);
      result.planes[i] = length > 0 ? glm::vec4(normal / length, -glm::dot(normal / length, a)) : glm::vec4(0);
    }
  });
  // The sides of all triangles, by the vertex with the lower number.
  std::vector<uint32_t> first(positions.size() + 1, 0);
  const auto forSides = [&](const auto& visit) {
    for (uint32_t i = 0; i < result.mesh.triangles.size(); ++i) {
      if (result.planes[i] == glm::vec4(0)) {
        continue;
      }
      const glm::uvec3& t = result.mesh.triangles[i];
      for (int corner = 0; corner < 3; ++corner) {
        const uint32_t from = t[corner];
        const uint32_t to = t[(corner + 1) % 3];
        visit(std::min(from, to), Side{std::max(from, to), i, from < to});
      }
    }
  };
  forSides([&](uint32_t vertex, const Side&) { ++first[vertex + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Side> sides(first.back());
  std::vector<uint32_t> next(first.begin(), first.end() - 1);
  forSides([&](uint32_t vertex, const Side& side) { sides[next[vertex]++] = side; });

  // Triangles in one plane share it: where no edge is between two, they must face every point alike.
  DisjointSets shared(result.mesh.triangles.size());
  for (uint32_t vertex = 0; vertex < positions.size(); ++vertex) {
    const auto begin = sides.begin() + first[vertex];
    const auto end = sides.begin() + first[vertex + 1];
    std::stable_sort(begin, end, [](const Side& p, const Side& q) { return p.to < q.to; });
    for (auto side = begin; side != end;) {
      const uint32_t from = side->ascends ? vertex : side->to;
      const uint32_t to = side->ascends ? side->to : vertex;
      OccluderEdge edge{positions[from], positions[to], side->triangle};
      const auto other = side + 1;
      if (other == end || other->to != side->to) {
        result.rims.push_back(edge);
        ++side;
        continue;
      }
      edge.other = other->triangle;
      edge.otherSign = side->ascends == other->ascends ? 1 : -1;
      const glm::vec3 p(result.planes[edge.plane]);
      const glm::vec3 q(result.planes[edge.other]);
      if (edge.otherSign < 0 && glm::dot(p, q) > 0 && glm::length(glm::cross(p, q)) < kSinFlat) {
        shared.join(edge.plane, edge.other);
      } else {
        result.folds.push_back(edge);
      }
      side += 2;
    }
  }
  for (OccluderEdge& rim : result.rims) {
    rim.plane = shared.least(rim.plane);
  }
  for (OccluderEdge& fold : result.folds) {
    fold.plane = shared.least(fold.plane);
    fold.other = shared.least(fold.other);
  }
  std::erase_if(result.folds, [](const OccluderEdge& e) { return e.plane == e.other && e.otherSign < 0; });
  return result;
}

}  // namespace ocelli
