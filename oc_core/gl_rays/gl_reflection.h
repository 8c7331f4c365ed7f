// A picture with mirrors that reflect depth images, drawn on the GPU alone: what the view shows by rasterisation, the
// reflected ray of each pixel from positions and normals of the mirrors, its first hit by gl_ray_walk.h, and an
// environment map for rays that hit nothing (sections 3.5.2.1 to 3.5.2.3). The picture is that of `ocelli shade
// --effect reflection`, but for pixels of silhouettes, which are rasterised here and cast there.
#pragma once

#include <optional>
#include <span>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/depth_rays/depth_image_target.h"
#include "oc_core/gl/pinhole_pass.h"
#include "oc_core/gl_rays/gl_ray_walk.h"

namespace ocelli {

/// What a picture with mirrors shows, taken apart. All of it is uploaded and may go afterwards.
struct MirrorScene {
  const Mesh& direct;                  ///< what is seen at once: all but the mirrors
  const Mesh& mirrors;                 ///< all of them; they are not seen in each other
  std::span<const glm::vec3> normals;  ///< unit, one a vertex of the mirrors
  const DepthImageTarget& target;      ///< what reflected rays hit
  const Mesh& billboards;              ///< what they hit exactly, beside it
  /// What they see else, linear: equirectangular and level, as PanoramaCamera has it for a view along -z.
  const Image<glm::vec3>& environment;
  glm::vec3 background{0};  ///< where the view shows nothing, linear
};

class GlReflection {
 public:
  /// The context must outlive it. Throws GlError where the GPU has no room, or its driver refuses a shader. Hold a
  /// GlScope, here and below.
  GlReflection(GlContext& context, const MirrorScene& scene);

  /// Other depth images that reflected rays hit; faster than another reflection.
  void setTarget(const DepthImageTarget& target);

  /// GL_RGBA32F: linear colours, alpha 1, row 0 at the top. A ray whose walk was given up (gl_ray_walk.h) sees past the
  /// depth images.
  GlObject draw(const PinholeCamera& camera) const;

 private:
  GlContext* context_;
  PinholePass pinhole_;
  GlMesh direct_;
  GlMesh mirrors_;
  GlObject normals_;
  GlRayWalk cast_;
  GlRayWalk billboards_;
  GlObject environment_;
  GlObject mirrorRays_;
  GlObject gatherRays_;
  glm::vec3 background_;
  float reach_;
};

}  // namespace ocelli
