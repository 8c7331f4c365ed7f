// What a pinhole camera sees of a mesh, drawn by the GPU's rasteriser: the closest triangle of each pixel first, then
// where on it the pixel lies.
#pragma once

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/gl/gl_fragments.h"
#include "oc_core/gl/gl_mesh.h"

namespace ocelli {

class PinholePass {
 public:
  /// Hold a GlScope, here and below.
  explicit PinholePass(GlContext& context);

  /// The closest fragment at each pixel; the first triangle on a tie. Both sides are drawn.
  GlFragments draw(const PinholeCamera& camera, const GlMesh& mesh) const;

 private:
  GlContext& context_;
  GlObject visibility_;
  GlObject resolve_;
};

}  // namespace ocelli
