// Ray maps for tests.
#pragma once

#include <cmath>
#include <random>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/camera/ray_map_camera.h"

namespace ocelli::test {

/// The rays of a camera at its pixel centres.
template <Camera C>
RayMap mapOfCamera(const C& camera, RayMapNotes notes = {}) {
  return RayMap::ofCamera(
      {camera.width(), camera.height()}, [&](const glm::vec2& pixel) { return camera.rayPath(pixel); },
      std::move(notes), "test");
}

inline RayMapCamera cameraOf(RayMap map) {
  return RayMapCamera(std::make_shared<const RayMap>(std::move(map)));
}

/// A function of pixel centres to origin and direction.
template <class Ray>
RayMap straightMap(const glm::ivec2& size, const Ray& ray, float near = 0, float far = 100, RayMapNotes notes = {}) {
  std::vector<glm::vec3> origins;
  std::vector<glm::vec3> directions;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const auto [origin, direction] = ray(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
      origins.emplace_back(origin);
      directions.emplace_back(direction);
    }
  }
  return RayMap::ofStraightRays(size, origins, directions, near, far, std::move(notes), "test");
}

/// Looks along -z from (0, 0, 10): half a sphere in a circle, angles in proportion to the distance from the middle.
inline RayMap fisheyeMap(int side) {
  return straightMap({side, side}, [&](double u, double v) {
    const glm::dvec2 p = glm::dvec2(u, v) / (side / 2.0) - 1.0;
    const double radius = glm::length(p);
    const double angle = radius * kPi / 2;
    const double sine = radius > 0 ? std::sin(angle) / radius : 0;
    return std::pair(glm::dvec3(0, 0, 10),
                     radius <= 1 ? glm::dvec3(p.x * sine, -p.y * sine, -std::cos(angle)) : glm::dvec3(0));
  });
}

/// Moves from x = -2 to 2 at z = 10 and looks along -z: columns are places, rows are angles.
inline RayMap pushBroomMap(const glm::ivec2& size) {
  return straightMap(size, [&](double u, double v) {
    const double angle = (0.5 - v / size.y) * 0.4;
    return std::pair(glm::dvec3(u / size.x * 4 - 2, 0, 10), glm::dvec3(0, std::sin(angle), -std::cos(angle)));
  });
}

/// Rays from anywhere to anywhere, which cross, and a fifth of the pixels without one.
inline RayMap randomMap(unsigned seed, const glm::ivec2& size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return glm::dvec3(number(random), number(random), number(random)); };
  return straightMap(
      size,
      [&](double u, double v) {
        const glm::dvec3 origin = glm::dvec3(u, v, 0) * 0.3 + vector() * 0.2;
        const glm::dvec3 direction = glm::dvec3(0, 0, 1) + vector() * 0.3;
        return std::pair(origin, number(random) < -0.6 ? glm::dvec3(0) : direction);
      },
      0.5f, 4);
}

}  // namespace ocelli::test
