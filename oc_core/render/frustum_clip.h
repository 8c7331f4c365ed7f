// Clips a triangle to the view frustum of a pinhole camera, in its camera space (right, down, forward).
#pragma once

#include <array>
#include <cstddef>

#include "oc_core/camera/pinhole_camera.h"

namespace ocelli {

/// How far beyond the image borders a vertex may project before its triangle is clipped, pixels.
inline constexpr float kClipMargin = 4096;

/// A camera-space point with its barycentric weights on the unclipped triangle.
struct ClipVertex {
  glm::vec3 p;
  float b1 = 0;
  float b2 = 0;
};

struct ClipPolygon {
  static constexpr size_t kMax = 3 + 6;  ///< each of six planes adds one vertex at most
  std::array<ClipVertex, kMax> vertices;
  size_t count = 0;
};

/// The part of the triangle with zNear <= z <= zFar and an image within `marginPixels` of the image borders. Triangles
/// that share an edge get the same points on it. Nothing where a coordinate is not finite.
ClipPolygon clipToFrustum(const std::array<glm::vec3, 3>& triangle, const PinholeCamera& camera, float marginPixels);

}  // namespace ocelli
