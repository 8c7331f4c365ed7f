// What lies between a box of receivers and a light: a bound for all of their lines of sight.
#pragma once

#include <algorithm>

#include "oc_core/scene/box.h"
#include "oc_core/soft_shadows/light_frame.h"

namespace ocelli {

class LightShaft {
 public:
  /// `receivers` is in the frame of the light and in front of it.
  LightShaft(const Box& receivers, const glm::vec2& halfLight) : receivers_(receivers), half_(halfLight) {}

  /// False only where no line from a point of the box of receivers to one of the light meets the box. At a height z
  /// a line to (x, y) on the light from p is at (x, y) (1 - z / p.z) + p z / p.z.
  bool meets(const glm::vec3& lower, const glm::vec3& upper) const {
    if (!(lower.z < receivers_.upper.z) || upper.z < 0) {
      return false;
    }
    const float nearest = std::max(lower.z, 0.0f) / receivers_.upper.z * (1 - kRounding);
    const float farthest = std::min(1.0f, upper.z / receivers_.lower.z * (1 + kRounding));
    for (int axis = 0; axis < 2; ++axis) {
      const float half = half_[axis];
      const float least = std::min(receivers_.lower[axis] * nearest - half * (1 - nearest),
                                   receivers_.lower[axis] * farthest - half * (1 - farthest));
      const float most = std::max(receivers_.upper[axis] * nearest + half * (1 - nearest),
                                  receivers_.upper[axis] * farthest + half * (1 - farthest));
      const float margin = kRounding * std::max({std::abs(least), std::abs(most), half});
      if (upper[axis] < least - margin || lower[axis] > most + margin) {
        return false;
      }
    }
    return true;
  }

  const Box& receivers() const { return receivers_; }

 private:
  static constexpr float kRounding = 4e-6f;

  Box receivers_;
  glm::vec2 half_;
};

/// The side of a plane on which all of a box lies: 1 or -1; 0 where it lies on both, or nearly.
inline int sideOfBox(const glm::vec4& plane, const Box& box) {
  const glm::vec3 normal(plane);
  const float middle = glm::dot(normal, box.center()) + plane.w;
  const float reach = glm::dot(glm::abs(normal), box.size()) * 0.5f;
  const float margin = 2e-6f * (glm::dot(glm::abs(normal), glm::abs(box.center())) + std::abs(plane.w));
  return middle > reach + margin ? 1 : middle < -(reach + margin) ? -1 : 0;
}

}  // namespace ocelli
