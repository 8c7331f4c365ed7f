// A straight piece of a ray, as it is intersected with samples, and the test with one triangle. For .cpp files and
// tests.
//
// What a test says depends on the ray and the triangle alone: so the order in which triangles are tested, and which of
// them are left out because the ray passes them by, changes no first hit.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>

namespace ocelli {

/// `origin + share * step` for shares from 0 to `reach`; numbers are finite.
struct StraightRay {
  /// A shorter one has no direction that single precision can tell.
  static constexpr float kMinStep = 1e-15f;

  glm::vec3 origin{0};
  glm::vec3 step{0};
  float reach = 1;

  bool hasDirection() const { return std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z)}) >= kMinStep; }
};

/// Where a ray meets a triangle.
struct TriangleMeeting {
  double share = 0;       ///< of the step
  uint32_t triangle = 0;  ///< its number
  float b1 = 0;           ///< barycentric weights of the second and third vertex
  float b2 = 0;

  /// Of triangles that are met at the same distance the first counts.
  bool comesBefore(const TriangleMeeting& other) const {
    return std::pair(share, triangle) < std::pair(other.share, other.triangle);
  }
};

/// Signed volumes in double precision: triangles that share an edge get the same number with the other sign, so no ray
/// passes between them. Both sides of a triangle are met. The place is a mean of the corners with weights that are not
/// negative: rounding never moves it out of the triangle, and so never out of a box around it.
inline std::optional<TriangleMeeting> meetTriangle(const StraightRay& ray, const glm::vec3& p, const glm::vec3& q,
                                                   const glm::vec3& r, uint32_t number) {
  const glm::dvec3 origin(ray.origin);
  const glm::dvec3 step(ray.step);
  const glm::dvec3 a = glm::dvec3(p) - origin;
  const glm::dvec3 b = glm::dvec3(q) - origin;
  const glm::dvec3 c = glm::dvec3(r) - origin;
  const double wa = glm::dot(step, glm::cross(b, c));
  const double wb = glm::dot(step, glm::cross(c, a));
  const double wc = glm::dot(step, glm::cross(a, b));
  const double sum = wa + wb + wc;
  const bool inside = (wa >= 0 && wb >= 0 && wc >= 0) || (wa <= 0 && wb <= 0 && wc <= 0);
  if (!inside || sum == 0) {
    return std::nullopt;
  }
  const glm::dvec3 place = (a * wa + b * wb + c * wc) / sum;
  const double share = glm::dot(place, step) / glm::dot(step, step);
  if (!(share >= 0 && share <= static_cast<double>(ray.reach))) {
    return std::nullopt;
  }
  return TriangleMeeting{share, number, static_cast<float>(wb / sum), static_cast<float>(wc / sum)};
}

}  // namespace ocelli
