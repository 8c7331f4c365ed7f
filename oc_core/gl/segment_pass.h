// Draws what lies in segments of straight rays (oc_core/render/straight_segment.h), by the GPU's rasteriser: blocks of
// triangles that the CPU finds, projected by the matrix of the segment, runs of blocks from the near to the far. Blocks
// that reach out of the segment are clipped with its first plane and tested by pixels, and no others are.
//
// Where a segment is one of several, depths are laid out first: pixels that its rays do not pass hold what is nearer
// than all else.
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
    std::vector<char> seen;  ///< by some pixel
    int width = 0;
    int height = 0;
  };
  Leaves upload(const PixelLeaves& leaves) const;

  /// Draws to the bound framebuffer, as samples (piece, triangle) of so numbered a piece, with the bound uniforms of
  /// the root. Depths are to be cleared before the first segment of each order.
  void draw(const StraightSegment& segment, uint32_t piece, const Leaves& leaves, const GlMesh& mesh,
            const MeshBlocks& blocks) const;

 private:
  void closeOtherPixels(const GlObject& endsOfLeaves, const Leaves& leaves) const;

  GlContext& context_;
  GlObject whole_;   ///< for blocks that lie in the segment
  GlObject tested_;  ///< for those that reach out of it
  GlObject mask_;
  GlObject noVertices_;
};

}  // namespace ocelli
