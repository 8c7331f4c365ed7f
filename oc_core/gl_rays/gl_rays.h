// Straight rays in the memory of the GPU, one a texel of two textures: what gl_ray_walk.h casts. Shaders may write
// them, too.
#pragma once

#include <span>

#include "oc_core/depth_rays/straight_ray.h"
#include "oc_core/gl/gl_object.h"

namespace ocelli {

class GlRays {
 public:
  /// What they hold is undefined, for shaders to write. Hold a GlScope, here and below. Throws GlError where the GPU
  /// has no room.
  GlRays(GlContext& context, int width, int height);
  /// Uploads them; a step of 0 stands for no ray.
  GlRays(GlContext& context, const Image<StraightRay>& rays);

  int width() const { return width_; }
  int height() const { return height_; }
  /// GL_RGBA32F: where each begins, world units, and how far it reaches, 1 being the end of its step.
  const GlObject& origins() const { return origins_; }
  /// GL_RGBA32F: its step; the fourth number says nothing.
  const GlObject& steps() const { return steps_; }

 private:
  int width_;
  int height_;
  GlObject origins_;
  GlObject steps_;
};

/// Rays of a list as an image, whose other texels hold no ray: those that follow each other are walked together.
Image<StraightRay> rayImage(std::span<const StraightRay> rays);
/// Where it holds the ray of a number: the index of the texel.
size_t rayTexel(const Image<StraightRay>& image, size_t ray);

}  // namespace ocelli
