// Meshes and volumes made by code for the tests of this room.
#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>

#include "display_sim/slicing/exact_slicer.h"
#include "oc_core/base/conventions.h"
#include "oc_core/scene/mesh.h"

namespace ocelli::test {

/// A closed grid of quads over two angles, `point(s, t)` with s and t in [0, 1); both directions wrap around.
template <class Point>
Mesh closedGrid(uint32_t across, uint32_t along, Point&& point) {
  Mesh mesh;
  for (uint32_t j = 0; j < along; ++j) {
    for (uint32_t i = 0; i < across; ++i) {
      mesh.positions.push_back(glm::vec3(point(static_cast<double>(i) / across, static_cast<double>(j) / along)));
    }
  }
  for (uint32_t j = 0; j < along; ++j) {
    for (uint32_t i = 0; i < across; ++i) {
      const uint32_t right = (i + 1) % across;
      const uint32_t down = (j + 1) % along;
      mesh.triangles.emplace_back(j * across + i, down * across + i, down * across + right);
      mesh.triangles.emplace_back(j * across + i, down * across + right, j * across + right);
    }
  }
  return mesh;
}

/// Around the y direction through `center`; the axis of the ring.
inline Mesh torus(double ringRadius, double tubeRadius, uint32_t across, uint32_t along,
                  const glm::dvec3& center = glm::dvec3(0)) {
  return closedGrid(across, along, [&](double s, double t) {
    const double r = ringRadius + tubeRadius * std::cos(2 * kPi * t);
    return center +
           glm::dvec3(r * std::cos(2 * kPi * s), tubeRadius * std::sin(2 * kPi * t), r * std::sin(2 * kPi * s));
  });
}

/// A closed sphere of `rings` bands from pole to pole, 2 * rings * (rings - 1) * 2 triangles.
inline Mesh sphere(double radius, uint32_t rings, const glm::dvec3& center = glm::dvec3(0)) {
  Mesh mesh;
  const uint32_t around = 2 * rings;
  mesh.positions.push_back(glm::vec3(center + glm::dvec3(0, radius, 0)));
  for (uint32_t j = 1; j < rings; ++j) {
    for (uint32_t i = 0; i < around; ++i) {
      const double polar = kPi * j / rings;
      const double turn = 2 * kPi * i / around;
      mesh.positions.push_back(glm::vec3(center + radius * glm::dvec3(std::sin(polar) * std::cos(turn), std::cos(polar),
                                                                      std::sin(polar) * std::sin(turn))));
    }
  }
  mesh.positions.push_back(glm::vec3(center - glm::dvec3(0, radius, 0)));
  const auto last = static_cast<uint32_t>(mesh.positions.size() - 1);
  for (uint32_t i = 0; i < around; ++i) {
    const uint32_t next = (i + 1) % around;
    mesh.triangles.emplace_back(0, 1 + next, 1 + i);
    for (uint32_t j = 0; j + 2 < rings; ++j) {
      const uint32_t row = 1 + j * around;
      mesh.triangles.emplace_back(row + i, row + next, row + around + next);
      mesh.triangles.emplace_back(row + i, row + around + next, row + around + i);
    }
    mesh.triangles.emplace_back(last, last - around + i, last - around + next);
  }
  return mesh;
}

/// Twelve large triangles.
inline Mesh box(const glm::vec3& lower, const glm::vec3& upper) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.emplace_back((i & 1) != 0 ? upper.x : lower.x, (i & 2) != 0 ? upper.y : lower.y,
                                (i & 4) != 0 ? upper.z : lower.z);
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

inline void addTriangle(Mesh& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  for (const glm::vec3& corner : {a, b, c}) {
    mesh.positions.push_back(corner);
  }
  mesh.triangles.emplace_back(first, first + 1, first + 2);
}

/// Random points in the cube of half side `reach`.
class PointSource {
 public:
  explicit PointSource(uint32_t seed) : engine_(seed) {}
  float uniform(float lo, float hi) {
    return lo + (hi - lo) * static_cast<float>(engine_() >> 8) * 0x1p-24f;  // the same on every platform
  }
  glm::vec3 point(float reach) { return {uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach)}; }

 private:
  std::mt19937 engine_;
};

/// A sliced ring with a colour of its own at every point.
inline Volume coloredTorus(const DisplayProfile& profile) {
  Mesh mesh = torus(0.6, 0.3, 40, 30);
  for (const glm::vec3& p : mesh.positions) {
    mesh.colors.push_back(glm::abs(p));
  }
  return sliceExactly(mesh, profile);
}

}  // namespace ocelli::test
