// A picture with mirrors that reflect depth images, drawn on the GPU alone: what the view shows by rasterisation, the
// reflected ray of each pixel from positions and normals of the mirrors, its first hit by gl_ray_walk.h, and an
// environment map for rays that hit nothing (sections 3.5.2.1 to 3.5.2.3). The picture is that of
// `ocelli shade --effect reflection`, but for pixels of silhouettes, which are rasterised here and cast there.
#pragma once

#include <span>

#include "oc_core/gl_rays/gl_ray_picture.h"

namespace ocelli {

class GlReflection {
 public:
  /// `mirrors` are all that mirrors; they are not seen in each other. `normals` are unit, one a vertex of them. The
  /// context must outlive it. Throws GlError where the GPU has no room, or its driver refuses a shader. Hold a GlScope,
  /// here and below.
  GlReflection(GlContext& context, const Mesh& mirrors, std::span<const glm::vec3> normals,
               const RayPictureScene& scene);

  /// Other depth images that reflected rays hit; faster than another reflection.
  void setTarget(const DepthImageTarget& target) { base_.setTarget(target); }

  /// GL_RGBA32F: linear colours, alpha 1, row 0 at the top.
  GlObject draw(const PinholeCamera& camera) const;

 private:
  GlContext* context_;
  GlRayPicture base_;
  GlMesh mirrors_;
  GlObject normals_;
  GlObject mirrorRays_;
};

}  // namespace ocelli
