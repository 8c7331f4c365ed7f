// Rays of any camera as shaders/listed_rays.glsl reads them: what of each lies within a volume, cut on the CPU
// (oc_core/volume_render/ray_pieces.h), and where it ends at a surface. For .cpp files.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "oc_core/gl/gl_object.h"
#include "oc_core/render/raycast.h"
#include "oc_core/volume/volume_scene.h"

namespace ocelli {

/// As the shader has a piece.
struct ListedPiece {
  glm::vec4 fromAndLength{0};          ///< the length is negative where the piece continues the one before
  glm::vec4 wayAndT{0};                ///< index coordinates by length, and the ray's parameter where it begins
  glm::vec4 directionAndTByLength{0};  ///< the direction in the scene's world
};

/// Rays of a row of an image.
struct ListedRow {
  std::vector<ListedPiece> pieces{};
  std::vector<uint32_t> counts{};     ///< of pieces, of each pixel
  std::vector<glm::vec4> surfaces{};  ///< of each pixel: the colour and the ray's parameter; none without surfaces
  double longest = 0;                 ///< of the rays, within the volume
};

class VolumeRayLister {
 public:
  using RayOfPixel = std::function<RayPath(const glm::vec2& pixel)>;

  /// The scene must outlive it, and its volume and surfaces must not change.
  explicit VolumeRayLister(const VolumeScene& scene);

  bool hasSurfaces() const { return surfaces_ != nullptr; }
  /// The rays through the pixel centres of some rows. On all threads.
  std::vector<ListedRow> rows(int width, int first, int end, const RayOfPixel& rayPath) const;

 private:
  const VolumeScene& scene_;
  std::unique_ptr<RayScene> surfaces_;
};

/// Rows that follow each other, in the memory of the GPU.
struct GlListedRows {
  GlObject pieces;
  GlObject firstPieces;
  GlObject surfaces;
};

/// Hold a GlScope. Throws GlError where the GPU has no room.
GlListedRows uploadRows(GlContext& context, const ListedRow* first, size_t count);

}  // namespace ocelli
