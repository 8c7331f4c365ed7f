// Draws what lies in segments of straight rays (oc_core/render/straight_segment.h), by the GPU's rasteriser: blocks of
// triangles that the CPU finds, projected by the matrix of the segment, runs of blocks from the near to the far. Blocks
// that reach out of the segment are clipped with its first plane and tested by pixels, and no others are. Triangles
// with corners that are not finite are left out, as on the CPU: what OpenGL draws of them is undefined.
//
// Rays of a segment that end elsewhere are drawn by themselves, with the blocks that they meet. Where their pixels do
// not fill a rectangle, depths are laid out first: all other pixels hold what is nearer than anything.
#pragma once

#include "oc_core/gl/gl_mesh.h"
#include "oc_core/gl/gl_object.h"
#include "oc_core/render/straight_segment.h"

namespace ocelli {

class SegmentPass {
 public:
  /// Hold a GlScope, here and below.
  explicit SegmentPass(GlContext& context);

  /// The leaves of one camera, for all of its segments.
  struct Leaves {
    GlObject texture;
    std::vector<PixelBounds> rects;  ///< around the pixels of each
    std::vector<size_t> pixels;      ///< how many these are
    bool isMasked = false;           ///< depths were laid out for some segment
  };
  Leaves upload(const PixelLeaves& leaves) const;

  /// Draws to the bound framebuffer, as samples (piece, triangle) of so numbered a piece, with the bound uniforms of
  /// the root. Depths are 0 where nothing was drawn. `blocks` are the mesh's, in its order.
  void draw(const StraightSegment& segment, uint32_t piece, Leaves& leaves, const GlMesh& mesh,
            const MeshBlocks& blocks) const;

 private:
  struct Kind;
  void drawKind(const StraightSegment& segment, const Kind& kind, uint32_t piece, Leaves& leaves, const GlMesh& mesh,
                const MeshBlocks& blocks) const;
  void closeOtherPixels(const Kind& kind, Leaves& leaves) const;

  GlContext& context_;
  GlObject whole_;   ///< for blocks that lie in the segment
  GlObject tested_;  ///< for those that reach out of it
  GlObject mask_;
  GlObject noVertices_;
};

}  // namespace ocelli
