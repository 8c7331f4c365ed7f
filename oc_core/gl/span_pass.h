// What a pinhole sees along epipolar lines, and what an epipolar occlusion camera sees, by spans (section 3.4.2):
// compute shaders cut the triangles along the lines and intersect each piece with the rays of its row. The same rules,
// in double precision, as oc_core/render/rasterize_spans.h.
//
// Samples compete by atomic minima, first of depths and then of triangles at that depth, so the image does not depend
// on any order.
#pragma once

#include "oc_core/camera/epipolar_camera.h"
#include "oc_core/gl/gl_fragments.h"
#include "oc_core/gl/gl_mesh.h"

namespace ocelli {

class SpanPass {
 public:
  /// Hold a GlScope, here and below.
  explicit SpanPass(GlContext& context);

  /// A row for each line, a column for each base pixel of the longest. For radial lines: where they are parallel, it is
  /// what the pinhole sees.
  GlFragments drawLines(const PinholeCamera& base, const EpipolarLines& lines, const GlMesh& mesh) const;

  /// `baseImage` is what drawLines() gives for the base and the lines of the camera.
  GlFragments draw(const EpipolarCamera& camera, const GlFragments& baseImage, const GlMesh& mesh) const;

 private:
  /// The programs that draw the base image, or what lies in disocclusions.
  struct Target {
    Target(GlContext& context, const char* name);
    GlObject selectTriangles;
    GlObject selectPieces;
    GlObject depth;
    GlObject index;
  };
  /// Triangles to be cut into spans, with the pieces that clipping left of some.
  struct Selection {
    GlObject items;
    GlObject pieces;
    uint32_t count = 0;
  };
  /// Depth and triangle of the closest sample at each place.
  struct Samples {
    GlObject depths;
    GlObject indices;
  };

  Selection select(const Target& target, uint32_t first, uint32_t count) const;
  GlObject clip(const GlObject& triangles, uint32_t count, uint32_t& pieces) const;
  Samples drawSpans(const Target& target, const GlMesh& mesh, int width, int height) const;

  GlContext& context_;
  Target base_;
  Target disocclusions_;
  GlObject countClipped_;
  GlObject emitClipped_;
  GlObject prefixSum_;
  GlObject tops_;
  GlObject resolveLines_;
  GlObject resolveCamera_;
};

}  // namespace ocelli
