// A portal: a rectangular opening through which one sees from one region of a scene into the next, such as a door, a
// window or the mouth of a corridor (dissertation, section 4.3.1.1).
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace ocelli {

struct Portal {
  glm::vec3 center{0};
  glm::vec3 normal{0, 0, 1};  ///< unit; towards the side from which one looks in
  glm::vec3 halfRight{1, 0, 0};
  glm::vec3 halfUp{0, 1, 0};  ///< (halfRight, halfUp, normal) is a right-handed orthogonal frame

  /// Counter-clockwise seen from where the normal points, the lower left one first.
  std::array<glm::vec3, 4> corners() const {
    return {center - halfRight - halfUp, center + halfRight - halfUp, center + halfRight + halfUp,
            center - halfRight + halfUp};
  }
};

/// `newFromOld` is a uniform scale and a translation, such as the one that fits a scene to the unit sphere.
inline Portal moved(const Portal& portal, const glm::mat4& newFromOld) {
  const float scale = newFromOld[0][0];
  return {glm::vec3(newFromOld * glm::vec4(portal.center, 1)), portal.normal, portal.halfRight * scale,
          portal.halfUp * scale};
}

}  // namespace ocelli
