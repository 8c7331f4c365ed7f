// How deep the plane of a receiver's surface lies where lines from the light's centre meet it. For .cpp files.
#pragma once

#include "oc_core/soft_shadows/area_visibility.h"

namespace ocelli {

class ReceiverPlane {
 public:
  explicit ReceiverPlane(const LitReceiver& lit)
      : normal_(lit.normal), height_(glm::dot(lit.normal, lit.position)), depth_(lit.position.z) {}

  /// At (x, y) / z = `slope`: no deeper than the receiver itself, as what lies behind that hides nothing from it.
  float depthAt(const glm::vec2& slope) const {
    const float along = normal_.x * slope.x + normal_.y * slope.y + normal_.z;
    const float depth = along * height_ > 0 ? height_ / along : depth_;
    return depth < depth_ ? depth : depth_;
  }

 private:
  glm::vec3 normal_;
  float height_;
  float depth_;
};

}  // namespace ocelli
