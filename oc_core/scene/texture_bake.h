// Textures baked to vertex colours. Where a texture is finer than the mesh, triangles are split, so that its detail
// survives.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "oc_core/scene/alpha_cut.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/scene/scene.h"
#include "oc_core/scene/texture_image.h"

namespace ocelli {

/// A texture on a mesh, with a coordinate a vertex.
struct TextureLayer {
  size_t texture = 0;  ///< index into the list of textures
  std::vector<glm::vec2> uvs;
};

/// A mesh whose textures have not yet become colours. It is drawn as colour * base + emission * emissive, with white
/// where one of them is missing, and at most 1; and where it has a mask, only where that is `maskCutoff` or more.
struct TexturedMesh {
  Mesh mesh;
  std::optional<TextureLayer> base;
  glm::vec3 emission{0};  ///< linear, 0 or more
  std::optional<TextureLayer> emissive;
  std::optional<TextureLayer> mask{};  ///< of values (Texture::value())
  float maskCutoff = 0.5f;             ///< positive; more than 1 leaves nothing
  bool isUnlit = false;                ///< its colours are light already
  /// What it has besides triangles, by its vertices.
  std::vector<glm::uvec2> lines{};
  std::vector<uint32_t> points{};
  /// Of the vertices that baking has added, which stand at the end: where each stands between vertices before it.
  std::vector<EdgeVertex> added{};

  bool hasTexture() const { return base || emissive || mask; }
};

/// As many triangles as textures may add to a scene that has hardly any others. Edges are halved, so that a pixel that
/// asks for two triangles may get 3.6: this leaves room for that.
inline constexpr size_t kMaxTextureTriangles = kMaxSceneTriangles / 2;

/// What became of the textures.
struct BakedTextures {
  double wanted = 0;   ///< triangles that whole textures add, two a pixel
  int halvings = 0;    ///< how often the width and the height of all textures were halved
  bool isCut = false;  ///< textures of one pixel would add too many, too: some colours of pixels are left out
};

/// Turns textures and emission into colours of vertices; a mesh without them stays as it is. At most `maxTriangles` new
/// triangles are made, in all; the first of these that fits is done:
///
/// - edges longer than 0.75 pixels of a texture are split, which makes eight triangles a pixel: colours are then those
///   of bilinear interpolation in the middle of each pixel and of its edges, and linear in between;
/// - edges longer than 1.5 pixels, two triangles a pixel: each vertex has the mean of the four pixels around it;
/// - the same, with all textures halved in size as often as that takes, which blurs, and makes no aliasing.
///
/// Edges that meet in the same places are split alike also where the texture has a seam. What masks leave out is cut
/// away.
BakedTextures bakeTextures(std::vector<TexturedMesh>& parts, std::vector<Texture> textures, size_t maxTriangles);

}  // namespace ocelli
