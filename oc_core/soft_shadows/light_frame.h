// Coordinates of an area light: x and y along its sides, from its centre, and z along its direction, world units. A
// point at z > 0 is one that it shines at. Seen from there, what stands at z between is projected onto the light.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "oc_core/scene/area_light.h"

namespace ocelli {

class LightFrame {
 public:
  /// A light that is smaller is taken as that large: nearly a point.
  static constexpr float kMinHalfSide = 1e-5f;

  explicit LightFrame(const AreaLight& light)
      : light_(light),
        direction_(light.direction()),
        half_(std::max(light.width / 2, kMinHalfSide), std::max(light.height / 2, kMinHalfSide)) {}

  const AreaLight& light() const { return light_; }
  const glm::vec2& half() const { return half_; }

  glm::vec3 fromWorld(const glm::vec3& p) const { return directionFromWorld(p - light_.center); }
  glm::vec3 directionFromWorld(const glm::vec3& v) const {
    return {glm::dot(v, light_.right), glm::dot(v, light_.up), glm::dot(v, direction_)};
  }
  glm::vec3 toWorld(const glm::vec3& p) const {
    return light_.center + light_.right * p.x + light_.up * p.y + direction_ * p.z;
  }

 private:
  AreaLight light_;
  glm::vec3 direction_;
  glm::vec2 half_;
};

}  // namespace ocelli
