// What a graph camera or a curved ray camera sees (chapter 4): one piece of its rays after the other, segments by
// segment_pass.h and bends by bend_pass.h. A ray meets what its first piece holds before anything that later ones do,
// so what is drawn once stays.
#pragma once

#include "oc_core/camera/graph_camera.h"
#include "oc_core/gl/bend_pass.h"
#include "oc_core/gl/gl_fragments.h"
#include "oc_core/gl/segment_pass.h"
#include "oc_core/render/mesh_blocks.h"

namespace ocelli {

class BentRayPass {
 public:
  /// Hold a GlScope, here and below.
  explicit BentRayPass(GlContext& context);

  /// The closest fragment along the ray of each pixel; both sides of triangles are drawn. `blocks` are the mesh's.
  GlFragments draw(const GraphCamera& camera, const GlMesh& mesh, const MeshBlocks& blocks) const;
  GlFragments draw(const CurvedRayCamera& camera, const GlMesh& mesh, const MeshBlocks& blocks) const;

 private:
  class Target;
  struct Ways;
  GlFragments resolve(const PinholeCamera& root, const Target& target, const Ways& ways, const GlMesh& mesh) const;

  GlContext& context_;
  SegmentPass segments_;
  BendPass bends_;
  GlObject resolve_;
};

}  // namespace ocelli
