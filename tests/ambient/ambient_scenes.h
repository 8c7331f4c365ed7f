// Scenes whose ambient light can be derived by hand, and their points.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "oc_core/ambient/ambient_points.h"
#include "oc_core/render/raycast.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli::test {

/// Two planes that meet at a right angle along the y axis, open towards +z: z = |x|.
inline Mesh valley(float half = 6) {
  Mesh mesh;
  addQuad(mesh, {-half, -half, half}, {0, -half, 0}, {0, half, 0}, {-half, half, half});
  addQuad(mesh, {0, -half, 0}, {half, -half, half}, {half, half, half}, {0, half, 0});
  return mesh;
}

/// Of what the other plane hides at a distance from the edge, with attenuation. Directions weigh as areas of the unit
/// disc below the hemisphere; those that meet the plane within the radius R have x >= c = distance / R, at a distance
/// of distance / x: the integral of 2 sqrt(1 - x^2) (1 - c^2 / x^2) / pi over x.
inline double hiddenInValley(double distance, double radius) {
  const double c = std::min(distance / radius, 1.0);
  return ((1 + 2 * c * c) * std::acos(c) - 3 * c * std::sqrt(1 - c * c)) / std::numbers::pi;
}

/// A plane z = 0 with a round pit of that radius and depth around the z axis, open towards +z.
inline Mesh pit(float radius, float depth, float half = 6) {
  constexpr int kSides = 256;
  Mesh mesh;
  for (int i = 0; i < kSides; ++i) {
    const auto around = [&](int k) {
      const double angle = 2 * std::numbers::pi * k / kSides;
      return glm::vec3(std::cos(angle), std::sin(angle), 0);
    };
    const glm::vec3 a = around(i);
    const glm::vec3 b = around(i + 1);
    const glm::vec3 down(0, 0, -depth);
    addQuad(mesh, a * half, b * half, b * radius, a * radius);
    addQuad(mesh, a * radius, b * radius, b * radius + down, a * radius + down);
    addQuad(mesh, down, down, a * radius + down, b * radius + down);
  }
  return mesh;
}

inline std::vector<AmbientPoint> pointsOf(const PinholeCamera& camera, const Mesh& mesh) {
  return ambientPoints(camera, raycast(camera, mesh, RayScene(mesh)), mesh);
}

}  // namespace ocelli::test
