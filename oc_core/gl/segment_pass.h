// Draws what lies in segments of straight rays (oc_core/render/straight_segment.h), by the GPU's rasteriser: blocks of
// triangles that the CPU finds, projected by the matrix of the segment, clipped with its first plane, and tested
// by pixels.
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
  GlObject upload(const PixelLeaves& leaves) const;

  /// Draws to the bound framebuffer, as samples of so numbered a piece, with the bound uniforms of the root.
  void draw(const StraightSegment& segment, uint32_t piece, const GlObject& leaves, const GlMesh& mesh,
            const MeshBlocks& blocks) const;

 private:
  GlContext& context_;
  GlObject program_;
  GlObject vertexArray_;
};

}  // namespace ocelli
