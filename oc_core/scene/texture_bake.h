// Textures baked to vertex colours. Where a texture is finer than the mesh, triangles are split, so that its detail
// survives.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "oc_core/scene/mesh.h"
#include "oc_core/scene/texture_image.h"

namespace ocelli {

/// A mesh whose texture coordinates, one a vertex, have not yet become colours.
struct TexturedMesh {
  Mesh mesh;
  std::vector<glm::vec2> uvs;
  size_t texture = 0;  ///< index into the list of textures
};

/// Multiplies the colour of each vertex (white where there is none) with its texture. Splits edges that are longer than
/// two pixels of the texture. Where that takes more than `mostTriangles` new triangles in all, textures are halved in
/// size until it does not, so a limit that is too low gives a blurred texture and no aliasing. Edges that meet in the
/// same places are split alike also where the texture has a seam.
void bakeTextures(std::vector<TexturedMesh>& parts, std::vector<Texture> textures, size_t mostTriangles);

}  // namespace ocelli
