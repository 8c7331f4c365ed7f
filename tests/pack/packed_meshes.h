// Meshes to pack, and what is compared of them.
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <vector>

#include "oc_core/pack/cluster.h"
#include "oc_core/pack/cluster_cut.h"
#include "oc_core/pack/pack_scene.h"
#include "oc_core/scene/densify.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/solids.h"

namespace ocelli::test {

/// A closed ball with bumps, of about so many triangles.
inline Mesh bumpyBall(size_t triangles) {
  Mesh ball = loadScene("builtin:sphere", {.shading = Shading::kNone});
  densify(ball, triangles);
  for (glm::vec3& p : ball.positions) {
    const glm::vec3 n = glm::normalize(p);
    p = n * (0.9f + 0.05f * std::sin(9 * n.x) * std::sin(7 * n.y) * std::cos(8 * n.z));
  }
  return ball;
}

inline PackedScene packed(const Mesh& mesh, const std::filesystem::path& path) {
  packScene(MeshSource(mesh), path);
  return PackedScene(path);
}

inline WeldedTriangles weldedOf(const Mesh& mesh) {
  Welder welder(mesh.positions.size());
  for (const glm::uvec3& t : mesh.triangles) {
    std::array<uint32_t, 3> corners{};
    for (glm::length_t k = 0; k < 3; ++k) {
      corners[static_cast<size_t>(k)] = welder.vertex(mesh.positions[t[k]], packedColor(mesh.color(t[k])));
    }
    welder.add(corners[0], corners[1], corners[2]);
  }
  return welder.take();
}

/// The grid of a plane, (n + 1)^2 vertices, with a vertex of its own for each corner of each triangle.
inline Mesh looseGrid(int n) {
  Mesh mesh;
  const auto corner = [&](int x, int y) {
    mesh.positions.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0f);
    return static_cast<uint32_t>(mesh.positions.size() - 1);
  };
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const uint32_t a = corner(x, y);
      const uint32_t b = corner(x + 1, y);
      const uint32_t c = corner(x + 1, y + 1);
      mesh.triangles.emplace_back(a, b, c);
      const uint32_t d = corner(x, y);
      const uint32_t e = corner(x + 1, y + 1);
      const uint32_t f = corner(x, y + 1);
      mesh.triangles.emplace_back(d, e, f);
    }
  }
  return mesh;
}

using Corner = std::tuple<float, float, float>;
inline Corner cornerOf(const glm::vec3& p) {
  return {p.x, p.y, p.z};
}

/// The triangles as positions, turned so that the least corner is first, sorted.
inline std::vector<std::array<Corner, 3>> trianglesOf(const Mesh& mesh) {
  std::vector<std::array<Corner, 3>> triangles;
  for (const glm::uvec3& t : mesh.triangles) {
    std::array<Corner, 3> corners{cornerOf(mesh.positions[t.x]), cornerOf(mesh.positions[t.y]),
                                  cornerOf(mesh.positions[t.z])};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.push_back(corners);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// Edges that are not passed once in each direction: cracks, and whatever else is not closed.
inline size_t openEdges(const Mesh& mesh) {
  std::map<std::pair<Corner, Corner>, int> passes;
  for (const glm::uvec3& t : mesh.triangles) {
    for (glm::length_t i = 0; i < 3; ++i) {
      const Corner a = cornerOf(mesh.positions[t[i]]);
      const Corner b = cornerOf(mesh.positions[t[(i + 1) % 3]]);
      ++passes[{a, b}];
      --passes[{b, a}];
    }
  }
  return static_cast<size_t>(std::count_if(passes.begin(), passes.end(), [](const auto& p) { return p.second != 0; }));
}

}  // namespace ocelli::test
