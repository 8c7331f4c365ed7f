// Small scenes, views and images whose answers can be derived by hand.
#pragma once

#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <string>

#include "oc_core/camera/distortion_map.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/image.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/worlds/solids.h"

namespace ocelli::test {

inline constexpr int kWidth = 90;
inline constexpr int kHeight = 60;

/// The default view: the eye at (0, 0, 10), looking at the origin.
inline PinholeCamera smallCamera() {
  return {View{}, kWidth, kHeight};
}

/// Corners in order around the quad; two triangles, (a, b, c) and (a, c, d).
inline void addQuad(Mesh& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d,
                    const glm::vec3& color = glm::vec3(0.5f)) {
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  for (const glm::vec3& corner : {a, b, c, d}) {
    mesh.positions.push_back(corner);
    mesh.colors.push_back(color);
  }
  mesh.triangles.emplace_back(first, first + 1, first + 2);
  mesh.triangles.emplace_back(first, first + 2, first + 3);
}

/// A square that faces +z.
inline void addWall(Mesh& mesh, float z, float half, const glm::vec3& color = glm::vec3(0.5f)) {
  addQuad(mesh, {-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}, color);
}

inline Mesh wall(float z, float half = 3) {
  Mesh mesh;
  addWall(mesh, z, half);
  return mesh;
}

/// A plane that fills the small camera's image, through the origin, its far side up: z = -steepness * y.
inline Mesh tiltedPlane(float steepness, float half = 3) {
  Mesh mesh;
  addQuad(mesh, {-half, -half, steepness * half}, {half, -half, steepness * half}, {half, half, -steepness * half},
          {-half, half, -steepness * half});
  return mesh;
}

inline constexpr float kBoxHalf = 0.3f;
inline constexpr float kBoxFrontZ = 0.7f;
inline constexpr float kWallZ = -0.9f;

/// A red box around the view axis before a grey wall. As it is the wall fills the image of every viewpoint of the view
/// cell; one of half side 0.9 is seen whole by all of them, so that what is missing is what the box hides.
inline Mesh boxBeforeWall(float wallHalf = 3) {
  Mesh mesh = wall(kWallZ, wallHalf);
  Mesh box = makeBox(glm::vec3(kBoxHalf));
  paint(box, {0.8f, 0.1f, 0.1f});
  append(mesh, box, glm::translate(glm::mat4(1), glm::vec3(0, 0, kBoxFrontZ - kBoxHalf)));
  return mesh;
}

/// A ball before a tilted back plane: curved silhouettes, no depth the same.
inline Mesh ballBeforePlane() {
  Mesh mesh;
  addQuad(mesh, {-3, -3, -0.5f}, {3, -3, -0.5f}, {3, 3, -1.2f}, {-3, 3, -1.2f}, {0.2f, 0.6f, 0.3f});
  Mesh ball = makeSphere(48);
  paint(ball, {0.1f, 0.2f, 0.8f});
  append(mesh, ball, glm::scale(glm::mat4(1), glm::vec3(0.5f)));
  return mesh;
}

/// `count` triangles with corners in a cube of half side 1.
inline Mesh randomTriangles(size_t count, unsigned seed) {
  std::mt19937 random(seed);
  const auto next = [&] { return static_cast<float>(random() >> 8) / static_cast<float>(1 << 23) - 1; };
  Mesh mesh;
  for (size_t i = 0; i < count; ++i) {
    const auto first = static_cast<uint32_t>(3 * i);
    for (int corner = 0; corner < 3; ++corner) {
      const float x = next();
      const float y = next();
      const float z = next();
      mesh.positions.emplace_back(x, y, z);
      mesh.colors.emplace_back((x + 1) / 2, (y + 1) / 2, (z + 1) / 2);
    }
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  return mesh;
}

/// A smooth field between z_n = 8 and z_f = 12 for every pixel: waves of `amplitude` pixels, each `wavelength` long. It
/// does not fold while 2 pi amplitude / wavelength is below 1.
inline DistortionMap wavyMap(int width, int height, float amplitude, float wavelength) {
  DistortionMap map(width, height, DistortionMap::Lookup::kBilinear);
  const float k = 2 * static_cast<float>(kPi) / wavelength;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::vec2 wave(std::sin(k * static_cast<float>(y)), std::cos(k * static_cast<float>(x)));
      map.samples()(x, y) = {amplitude * wave, 1 / 8.0f, 1 / 12.0f};
    }
  }
  return map;
}

/// Equal as bytes: no tolerance, and a NaN equals itself.
template <class T>
bool sameBytes(const Image<T>& a, const Image<T>& b) {
  return a.width() == b.width() && a.height() == b.height() &&
         (a.size() == 0 || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}
template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

}  // namespace ocelli::test
