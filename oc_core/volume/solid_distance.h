// Signed distances to simple solids, negative inside, of what made volumes are put together from; approximate for
// ellipsoids. For .cpp files of this room.
//
//   I. Quilez, "Distance functions" (https://iquilezles.org/articles/distfunctions)
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ocelli::solid {

inline float sphere(const glm::vec3& p, const glm::vec3& center, float radius) {
  return glm::length(p - center) - radius;
}

/// Right at the surface, to first order near it.
inline float ellipsoid(const glm::vec3& p, const glm::vec3& center, const glm::vec3& radii) {
  const glm::vec3 scaled = (p - center) / radii;
  const float slope = glm::length(scaled / radii);
  const float reach = glm::length(scaled);
  return slope > 0 ? reach * (reach - 1) / slope : -std::min({radii.x, radii.y, radii.z});
}

inline float box(const glm::vec3& p, const glm::vec3& center, const glm::vec3& halfSize, float rounding) {
  const glm::vec3 beyond = glm::abs(p - center) - halfSize + rounding;
  return glm::length(glm::max(beyond, 0.0f)) + std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0f) - rounding;
}

/// The line from `a` to `b`, thick and with round ends.
inline float capsule(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, float radius) {
  const glm::vec3 along = b - a;
  const float share = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0f, 1.0f);
  return glm::length(p - a - along * share) - radius;
}

/// `across` is the distance from the axis, and `along` that from the middle.
inline float cylinder(float across, float along, float radius, float halfLength) {
  const glm::vec2 beyond(across - radius, std::abs(along) - halfLength);
  return std::min(std::max(beyond.x, beyond.y), 0.0f) + glm::length(glm::max(beyond, 0.0f));
}

/// Around an axis of the world (0 for x, ...): of the circle's radius and the tube's.
inline float torus(const glm::vec3& p, const glm::vec3& center, int axis, float radius, float tube) {
  const glm::vec3 d = p - center;
  const glm::vec2 plane(d[(axis + 1) % 3], d[(axis + 2) % 3]);
  return glm::length(glm::vec2(glm::length(plane) - radius, d[axis])) - tube;
}

/// What is in both, and what is in the first and not in the other.
inline float both(float a, float b) {
  return std::max(a, b);
}
inline float without(float a, float b) {
  return std::max(a, -b);
}
/// The union, its seam rounded over about `width`.
inline float smoothUnion(float a, float b, float width) {
  const float share = std::clamp(0.5f + 0.5f * (b - a) / width, 0.0f, 1.0f);
  return glm::mix(b, a, share) - width * share * (1 - share);
}

/// From 0 outside to 1 inside over a ramp of this width: of a voxel's edge, how much of a voxel a solid covers.
inline float coverage(float distance, float ramp) {
  return std::clamp(0.5f - distance / ramp, 0.0f, 1.0f);
}

}  // namespace ocelli::solid
