// Spheres that bound what a scene holds: the hierarchy of a packed scene is tested against views with them.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace ocelli {

struct Sphere {
  glm::vec3 center{0};
  float radius = -1;  ///< negative where it holds nothing

  bool empty() const { return radius < 0; }
};

/// Around both, and not larger than it has to be but for rounding, which never leaves anything outside.
inline Sphere around(const Sphere& a, const Sphere& b) {
  if (a.empty() || b.empty()) {
    return a.empty() ? b : a;
  }
  const glm::vec3 step = b.center - a.center;
  const float distance = glm::length(step);
  if (distance + b.radius <= a.radius) {
    return a;
  }
  if (distance + a.radius <= b.radius) {
    return b;
  }
  constexpr float kRounding = 1 + 4e-7f;
  const float radius = 0.5f * (distance + a.radius + b.radius);
  return {a.center + step * ((radius - a.radius) / distance), radius * kRounding};
}

/// Around all of them.
inline Sphere around(std::span<const Sphere> spheres) {
  Sphere all;
  for (const Sphere& sphere : spheres) {
    all = around(all, sphere);
  }
  return all;
}

/// Around points: centred in their box, so at most sqrt(3) times as large as it has to be.
inline Sphere aroundPoints(std::span<const glm::vec3> points) {
  if (points.empty()) {
    return {};
  }
  glm::vec3 lower = points[0];
  glm::vec3 upper = points[0];
  for (const glm::vec3& p : points) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
  }
  const glm::vec3 center = lower + (upper - lower) * 0.5f;
  float radius2 = 0;
  for (const glm::vec3& p : points) {
    radius2 = std::max(radius2, glm::dot(p - center, p - center));
  }
  constexpr float kRounding = 1 + 4e-7f;
  return {center, std::sqrt(radius2) * kRounding};
}

}  // namespace ocelli
