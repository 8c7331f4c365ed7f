// What a camera that displaces the image of a pinhole sees, by subdivision (section 6.1.3): compute shaders split the
// triangles until their pieces are about a pixel in size, and the GPU's rasteriser fills these as if their edges were
// straight. The same rules as oc_core/render/rasterize_subdivided.h.
//
// Why no tessellation shader: its levels are bounded and uniform over a triangle, where the field of a DDOC, or
// a floor that reaches from the eye to the horizon, needs pieces of very different size. Measured on a software
// renderer, it is slower for scans and wrong for large triangles (docs/results.md, "On the GPU").
#pragma once

#include "oc_core/gl/displacement_uniforms.h"
#include "oc_core/gl/gl_fragments.h"
#include "oc_core/gl/gl_mesh.h"
#include "oc_core/gl/piece_splitter.h"
#include "oc_core/render/rasterize_subdivided.h"

namespace ocelli {

class SubdivisionPass {
 public:
  /// Hold a GlScope, here and below.
  explicit SubdivisionPass(GlContext& context);

  /// `seen` is what the reference pinhole sees.
  GlFragments draw(const SpocCamera& camera, const GlFragments& seen, const GlMesh& mesh,
                   const SubdivisionOptions& options) const;
  GlFragments draw(const ReversePinholeCamera& camera, const GlFragments& seen, const GlMesh& mesh,
                   const SubdivisionOptions& options) const;
  GlFragments draw(const DdocCamera& camera, const GlFragments& seen, const GlMesh& mesh,
                   const SubdivisionOptions& options) const;

 private:
  /// The programs of one camera model.
  struct Model {
    Model(GlContext& context, int number);
    SplitPrograms split;
    GlObject keepUndisplaced;
  };

  GlFragments drawModel(const Model& model, const PinholeCamera& reference, const DisplacementBlock& block,
                        const GlFragments& seen, const GlMesh& mesh) const;

  GlContext& context_;
  mutable PieceSplitter splitter_;
  Model spoc_;
  Model reversePinhole_;
  Model ddoc_;
  GlObject vertexArray_;
};

}  // namespace ocelli
