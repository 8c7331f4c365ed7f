// Draws what lies in bends of a curved ray camera (oc_core/render/bend_rasterizer.h): compute shaders split triangles
// until their pieces come out straight, as for cameras that displace an image (subdivision_pass.h), and the GPU's
// rasteriser fills these.
#pragma once

#include "oc_core/camera/curved_ray_camera.h"
#include "oc_core/gl/piece_splitter.h"
#include "oc_core/render/bend_projection.h"

namespace ocelli {

class BendPass {
 public:
  /// Hold a GlScope, here and below.
  explicit BendPass(GlContext& context);

  /// Draws to the bound framebuffer, as samples of so numbered a piece, with the bound uniforms of the root.
  /// `projection` is that of the bend, `blocks` are the mesh's.
  void draw(const CurvedRayCamera& camera, size_t bend, const BendProjection& projection, uint32_t piece,
            const GlMesh& mesh, const MeshBlocks& blocks) const;

 private:
  GlContext& context_;
  mutable PieceSplitter splitter_;
  SplitPrograms conic_;
  mutable std::optional<SplitPrograms> bezier_;  ///< made when first drawn with
  GlObject vertexArray_;
};

}  // namespace ocelli
