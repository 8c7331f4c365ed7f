// What pictures with rays that go on have in common on the GPU: what the view shows at once, by rasterisation, and what
// the rays see: depth images, billboards, an environment map. gl_reflection.h and gl_refraction.h put the rays between.
#pragma once

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/depth_rays/depth_image_target.h"
#include "oc_core/gl/gl_fragments.h"
#include "oc_core/gl/gl_mesh.h"
#include "oc_core/gl/pinhole_pass.h"
#include "oc_core/gl_rays/gl_ray_walk.h"

namespace ocelli {

/// All but what sends rays on. It is uploaded, and may go afterwards.
struct RayPictureScene {
  const Mesh& direct;              ///< what the view shows at once
  const DepthImageTarget& target;  ///< what rays hit
  const Mesh& billboards;          ///< what they hit exactly, beside it; of few triangles
  /// What they see else, linear: equirectangular and level, as PanoramaCamera has it for a view along -z.
  const Image<glm::vec3>& environment;
  glm::vec3 background{0};  ///< where the view shows nothing, linear
};

class GlRayPicture {
 public:
  /// `senders` are the bounds of what sends rays on. The context must outlive it. Throws GlError where the GPU has no
  /// room, or its driver refuses a shader. Hold a GlScope, here and below.
  GlRayPicture(GlContext& context, const RayPictureScene& scene, const Box& senders);

  /// Other depth images that rays hit.
  void setTarget(const DepthImageTarget& target);

  struct Start {
    GlObject picture;  ///< GL_RGBA32F: what is seen at once, linear, alpha 1
    GlObject nearest;  ///< GL_R32F: its depth z
    GlRays rays;       ///< none yet
    GlObject pinhole;  ///< the camera, for binding 0 of uniform buffers
  };
  Start begin(const PinholeCamera& camera) const;
  /// What the view shows of one mesh alone.
  GlFragments draw(const PinholeCamera& camera, const GlMesh& mesh) const { return pinhole_.draw(camera, mesh); }
  /// Puts what rays see into the pixels that send one. A ray whose walk was given up (gl_ray_walk.h) sees past the
  /// depth images.
  void gather(const GlRays& rays, const GlObject& picture) const;

  /// Of rays, world units: from anywhere within to everything.
  float reach() const { return reach_; }

 private:
  GlContext* context_;
  PinholePass pinhole_;
  GlMesh direct_;
  GlRayWalk cast_;
  GlRayWalk billboards_;
  GlObject environment_;
  GlObject directPicture_;
  GlObject gatherRays_;
  glm::vec3 background_;
  float reach_;
};

/// A mesh that rays hit exactly.
GlRayWalk walkOverMesh(GlContext& context, const Mesh& mesh);

}  // namespace ocelli
