// A picture with objects of glass through which depth images are seen, drawn on the GPU alone: the view's rays are
// refracted where they enter, walk through the object's own triangles, and leave it refracted, or reflected inside as
// often as four times (section 3.5.2.3.1). The picture is that of `ocelli shade --effect refraction`, but for pixels of
// silhouettes, which are rasterised here and cast there.
#pragma once

#include <span>
#include <vector>

#include "oc_core/gl_rays/gl_ray_picture.h"

namespace ocelli {

/// An object of clear glass; it is uploaded, and may go afterwards.
struct GlassObject {
  const Mesh& mesh;
  std::span<const glm::vec3> normals;  ///< unit, one a vertex
  float refractiveIndex = 1.5f;
};

class GlRefraction {
 public:
  /// The objects are not seen through each other. The context must outlive it. Throws GlError where the GPU has no
  /// room, or its driver refuses a shader. Hold a GlScope, here and below.
  GlRefraction(GlContext& context, std::span<const GlassObject> objects, const RayPictureScene& scene);

  /// Other depth images that rays hit; faster than another refraction.
  void setTarget(const DepthImageTarget& target) { base_.setTarget(target); }

  /// GL_RGBA32F: linear colours, alpha 1, row 0 at the top.
  GlObject draw(const PinholeCamera& camera) const;

 private:
  struct Glass {
    GlRayWalk walk;
    GlObject normals;
    float index;
    float size;  ///< the diagonal of its bounds
  };
  void sendThrough(const Glass& glass, const PinholeCamera& camera, const GlRayPicture::Start& start) const;

  GlContext* context_;
  GlRayPicture base_;
  std::vector<Glass> glasses_;
  GlObject enter_;
  GlObject leave_;
};

}  // namespace ocelli
