// How a material moves the texture coordinates of a glTF file (extension KHR_texture_transform).
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

namespace ocelli {

/// As the extension defines it, for coordinates whose origin is the top left corner of the image and whose v points
/// down.
struct TextureTransform {
  glm::vec2 offset{0};
  float rotation = 0;  ///< radians; turns the coordinates counter-clockwise, as one looks at the image
  glm::vec2 scale{1};
};

/// Assimp's form of the same, whose origin is the bottom left and which turns about the middle of the image.
struct AssimpTransform {
  glm::vec2 translation{0};
  float rotation = 0;
  glm::vec2 scaling{1};
};

/// Undoes what Assimp's glTF importer did: its form agrees with the extension only where both axes have one scale.
TextureTransform textureTransform(const AssimpTransform& transform);

/// For coordinates whose origin is the bottom left, as Assimp gives them: (u', v', 1) = matrix * (u, v, 1).
glm::mat3 matrixOf(const TextureTransform& transform);

}  // namespace ocelli
