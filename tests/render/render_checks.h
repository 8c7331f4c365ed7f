// What a rendered fragment must agree with, computed in double precision from the triangle itself.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/render/fragment_image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli::test {

/// Vertices are snapped to 1/256 pixel, so each of them, and with them every point of a triangle's image, moves by at
/// most half the diagonal of that grid.
inline const double kSnapPixels = std::sqrt(2.0) / 512;

/// The image of a triangle that lies wholly in front of the eye: 1/z is linear over it.
struct TriangleImage {
  std::array<glm::dvec2, 3> corners;
  glm::dvec2 slope{0};  ///< of 1/z, for a pixel
  double inverseZ0 = 0;

  TriangleImage(const PinholeCamera& camera, const Mesh& mesh, uint32_t triangle) {
    std::array<double, 3> w{};
    for (int i = 0; i < 3; ++i) {
      const glm::vec3 p = camera.cameraFromWorld(mesh.positions[mesh.triangles[triangle][i]]);
      const auto k = static_cast<size_t>(i);
      corners[k] = {camera.width() / 2.0 + static_cast<double>(camera.focalPixels()) * p.x / p.z,
                    camera.height() / 2.0 + static_cast<double>(camera.focalPixels()) * p.y / p.z};
      w[k] = 1.0 / p.z;
    }
    const glm::dvec2 e1 = corners[1] - corners[0];
    const glm::dvec2 e2 = corners[2] - corners[0];
    const double area = e1.x * e2.y - e1.y * e2.x;
    slope = {((w[1] - w[0]) * e2.y - (w[2] - w[0]) * e1.y) / area,
             ((w[2] - w[0]) * e1.x - (w[1] - w[0]) * e2.x) / area};
    inverseZ0 = w[0] - glm::dot(slope, corners[0]);
  }

  double inverseZ(const glm::dvec2& p) const { return inverseZ0 + glm::dot(slope, p); }

  /// Pixels between `p` and the nearest edge.
  double edgeDistance(const glm::dvec2& p) const {
    double nearest = 1e30;
    for (size_t i = 0; i < 3; ++i) {
      const glm::dvec2 a = corners[i];
      const glm::dvec2 ab = corners[(i + 1) % 3] - a;
      const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
      nearest = std::min(nearest, glm::distance(p, a + ab * t));
    }
    return nearest;
  }
};

/// Two renderers may show different triangles at a pixel only where one of the two ends within `pixels` of the pixel's
/// centre, or where both are equally far away there, as far as an image moved by `pixels` can tell.
inline bool mayDiffer(const Fragment& a, const Fragment& b, const PinholeCamera& camera, const Mesh& mesh, int x, int y,
                      double pixels) {
  const glm::dvec2 centre(x + 0.5, y + 0.5);
  double tolerance = 0;
  std::array<double, 2> inverseZ{};
  for (size_t i = 0; i < 2; ++i) {
    const Fragment& f = i == 0 ? a : b;
    if (f.covered()) {
      const TriangleImage image(camera, mesh, f.triangle);
      if (image.edgeDistance(centre) <= pixels) {
        return true;
      }
      inverseZ[i] = image.inverseZ(centre);
      tolerance += glm::length(image.slope) * pixels;
    }
  }
  // 1e-6: rounding of 1/z in single precision, relative.
  return a.covered() && b.covered() && std::abs(inverseZ[0] - inverseZ[1]) <= tolerance + 1e-6 * inverseZ[0];
}

/// Adds triangles with corners that are no numbers, and some without an area. The mesh has colours.
inline void addBrokenTriangles(Mesh& mesh) {
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  mesh.positions.insert(mesh.positions.end(), {{nan, 0, 0}, {infinite, 1, 0}, {0, 0, -infinite}});
  mesh.colors.resize(mesh.positions.size(), glm::vec3(1));
  for (uint32_t i = 0; i < 3; ++i) {
    mesh.triangles.push_back({first + i, 0, 1});
    mesh.triangles.push_back({0, 0, 0});
  }
}

/// Gives some triangles corners of their own that are not finite: every seventh, and all of the second block and of the
/// second run of blocks (oc_core/render/mesh_blocks.h). Returns the mesh with triangles without an area in their place.
inline Mesh breakTriangles(Mesh& mesh) {
  constexpr size_t kBlock = 32;
  constexpr size_t kRun = 32 * kBlock;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  const std::array<glm::vec3, 4> wrong{
      {{kNan, 0, 0}, {0, kInfinite, 0}, {0.1f, -0.2f, -kInfinite}, {kInfinite, kNan, 0}}};
  Mesh without = mesh;
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % 7 == 3 || i / kBlock == 1 || i / kRun == 1) {
      const auto corner = static_cast<uint32_t>(mesh.positions.size());
      mesh.positions.push_back(wrong[i % wrong.size()]);
      mesh.colors.emplace_back(1);
      mesh.triangles[i][static_cast<int>(i % 3)] = corner;
      without.triangles[i] = {0, 0, 0};
    }
  }
  return without;
}

}  // namespace ocelli::test
