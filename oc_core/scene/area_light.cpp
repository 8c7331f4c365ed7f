#include "oc_core/scene/area_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"

namespace ocelli {

glm::vec3 AreaLight::direction() const {
  return glm::cross(right, up);
}

AreaLight areaLightTowards(const glm::vec3& center, const glm::vec3& target, float width, float height, bool isDisc,
                           double turnDegrees, const std::string& where) {
  const glm::vec3 way = target - center;
  if (!(glm::length(way) > 1e-6f)) {
    throw InputError("the centre of the light is its target", where, "let it shine somewhere else");
  }
  const glm::vec3 direction = glm::normalize(way);
  const glm::vec3 vertical = std::abs(direction.y) > 0.999f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
  const glm::vec3 right = glm::normalize(glm::cross(vertical, direction));
  const glm::vec3 up = glm::cross(direction, right);
  const auto turn = static_cast<float>(radiansFromDegrees(turnDegrees));
  return {
      center, right * std::cos(turn) + up * std::sin(turn), up * std::cos(turn) - right * std::sin(turn), width, height,
      isDisc};
}

AreaLight areaLightOfPanel(const Mesh& panel, const std::string& where) {
  glm::dvec3 normal(0);
  glm::dvec3 longest(0);
  for (const glm::uvec3& t : panel.triangles) {
    const glm::dvec3 a(panel.positions[t.x]);
    const glm::dvec3 b(panel.positions[t.y]);
    const glm::dvec3 c(panel.positions[t.z]);
    normal += glm::cross(b - a, c - a);
    // The sides of a rectangle, not the diagonals of its triangles: the two shorter edges of each.
    std::array<glm::dvec3, 3> edges{b - a, c - b, a - c};
    std::sort(edges.begin(), edges.end(),
              [](const glm::dvec3& p, const glm::dvec3& q) { return glm::dot(p, p) < glm::dot(q, q); });
    longest = glm::dot(edges[1], edges[1]) > glm::dot(longest, longest) ? edges[1] : longest;
  }
  if (!(glm::length(normal) > 0) || !(glm::length(longest) > 0)) {
    throw InputError("the object with the role \"light\" has no area", where, "give that role to a flat panel");
  }
  const double area = glm::length(normal) / 2;
  normal = glm::normalize(normal);
  const glm::dvec3 right = glm::normalize(longest - normal * glm::dot(longest, normal));
  const glm::dvec3 up = glm::cross(normal, right);
  glm::dvec3 lower(1e30);
  glm::dvec3 upper(-1e30);
  for (const glm::uvec3& t : panel.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const glm::dvec3 p(panel.positions[t[corner]]);
      const glm::dvec3 own(glm::dot(p, right), glm::dot(p, up), glm::dot(p, normal));
      lower = glm::min(lower, own);
      upper = glm::max(upper, own);
    }
  }
  const glm::dvec3 size = upper - lower;
  constexpr double kFlat = 1e-3;
  if (size.z > kFlat * std::max(size.x, size.y)) {
    throw InputError("the object with the role \"light\" is not flat", where, "give that role to a flat panel");
  }
  constexpr double kDiscArea = kPi / 4;  // of its rectangle; a polygon of 12 sides or more is one
  const bool isDisc = area < 1.01 * kDiscArea * size.x * size.y && area > 0.95 * kDiscArea * size.x * size.y;
  const glm::dvec3 middle = (lower + upper) * 0.5;
  return {glm::vec3(right * middle.x + up * middle.y + normal * middle.z),
          glm::vec3(right),
          glm::vec3(up),
          static_cast<float>(size.x),
          static_cast<float>(size.y),
          isDisc};
}

Mesh panelOf(const AreaLight& light) {
  Mesh panel;
  const glm::vec3 x = light.right * (light.width / 2);
  const glm::vec3 y = light.up * (light.height / 2);
  if (!light.isDisc) {
    panel.positions = {light.center - x - y, light.center + x - y, light.center + x + y, light.center - x + y};
    panel.triangles = {{0, 1, 2}, {0, 2, 3}};
    return panel;
  }
  constexpr uint32_t kSides = 48;
  panel.positions.push_back(light.center);
  for (uint32_t i = 0; i < kSides; ++i) {
    const auto angle = static_cast<float>(2 * kPi * i / kSides);
    panel.positions.push_back(light.center + x * std::cos(angle) + y * std::sin(angle));
    panel.triangles.push_back({0, 1 + i, 1 + (i + 1) % kSides});
  }
  return panel;
}

}  // namespace ocelli
