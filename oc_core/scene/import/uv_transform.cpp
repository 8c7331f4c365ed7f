#include "oc_core/scene/import/uv_transform.h"

#include <cmath>

namespace ocelli {

TextureTransform textureTransform(const AssimpTransform& transform) {
  const glm::vec2 scale = transform.scaling;
  const float rotation = -transform.rotation;
  const float c = std::cos(rotation);
  const float s = std::sin(rotation);
  // glTF2Importer.cpp adds these to the offset, and mirrors it in v.
  const float shiftU = 0.5f * scale.x * (1 - c + s);
  const float shiftV = 0.5f * scale.y * (s + c - 1) + 1 - scale.y;
  return {{transform.translation.x - shiftU, shiftV - transform.translation.y}, rotation, scale};
}

glm::mat3 matrixOf(const TextureTransform& transform) {
  // With v downwards, KHR_texture_transform is (u', v') = offset + R * (scale * (u, v)), R = (c s; -s c). The listing
  // of the extension has R the other way round, which its own example and all who implement it contradict
  // (github.com/KhronosGroup/glTF/issues/1563). With v upwards, v = 1 - v_up, so:
  const float c = std::cos(transform.rotation);
  const float s = std::sin(transform.rotation);
  const glm::vec2 scale = transform.scale;
  return {glm::vec3(c * scale.x, s * scale.x, 0), glm::vec3(-s * scale.y, c * scale.y, 0),
          glm::vec3(s * scale.y + transform.offset.x, 1 - c * scale.y - transform.offset.y, 1)};
}

}  // namespace ocelli
