// Properties of meshes that several tests assert.
#pragma once

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Whether each directed edge between two places has its opposite exactly once: no hole, no crack, one orientation.
inline bool isClosed(const Mesh& mesh) {
  using Place = std::array<float, 3>;
  std::map<std::array<Place, 2>, int> balance;
  for (const glm::uvec3& t : mesh.triangles) {
    for (glm::length_t i = 0; i < 3; ++i) {
      const glm::vec3& a = mesh.positions[t[i]];
      const glm::vec3& b = mesh.positions[t[(i + 1) % 3]];
      ++balance[{Place{a.x, a.y, a.z}, Place{b.x, b.y, b.z}}];
    }
  }
  for (const auto& [edge, count] : balance) {
    const auto opposite = balance.find({edge[1], edge[0]});
    if (count != 1 || opposite == balance.end() || opposite->second != 1) {
      return false;
    }
  }
  return true;
}

/// Whether each directed edge has as many opposite ones, as in a union of closed solids that may touch.
inline bool isBalanced(const Mesh& mesh) {
  using Place = std::array<float, 3>;
  std::map<std::array<Place, 2>, int> balance;
  for (const glm::uvec3& t : mesh.triangles) {
    for (glm::length_t i = 0; i < 3; ++i) {
      const glm::vec3& a = mesh.positions[t[i]];
      const glm::vec3& b = mesh.positions[t[(i + 1) % 3]];
      const Place from{a.x, a.y, a.z};
      const Place to{b.x, b.y, b.z};
      ++balance[{from, to}];
      --balance[{to, from}];
    }
  }
  return std::all_of(balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 0; });
}

inline double areaOf(const Mesh& mesh) {
  double area = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]);
    area += glm::length(glm::cross(glm::dvec3(mesh.positions[t.y]) - a, glm::dvec3(mesh.positions[t.z]) - a)) / 2;
  }
  return area;
}

/// Positive where the triangles of a closed mesh are counter-clockwise seen from outside.
inline double signedVolume(const Mesh& mesh) {
  double volume = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    volume += glm::dot(glm::dvec3(mesh.positions[t.x]),
                       glm::cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z]))) /
              6;
  }
  return volume;
}

}  // namespace ocelli
