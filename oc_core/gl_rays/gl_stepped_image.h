// The text's way to the first hit of a ray (section 3.5.2.2) on the GPU: stepped_image.h as a compute shader, for
// cameras whose projection the shaders have.
#pragma once

#include <optional>

#include "oc_core/depth_rays/stepped_image.h"
#include "oc_core/gl/displacement_uniforms.h"
#include "oc_core/gl/epipolar_uniforms.h"
#include "oc_core/gl_rays/gl_rays.h"

namespace ocelli {

/// Of an image of rays, a texel a ray.
struct GlSteppedHits {
  /// GL_RGBA32F: the distance from the origin in world units, the place in the image in pixels, and the opacity; 0
  /// where nothing is hit. A distance of kUnansweredDistance (gl_ray_walk.h) where the walk was given up.
  GlObject hits;
  GlObject colors;  ///< GL_RGBA32F: the linear colour of the sample there, and the opacity; 0 where nothing is hit
  GlObject costs;   ///< GL_RGBA32UI: coarse steps, fine steps, 0, 0
};

class GlSteppedImage {
 public:
  /// Uploads the image and its projection: `camera` is the one that `image` was given the map of. Nothing of them is
  /// kept. The context must outlive it. Throws GlError where the GPU has no room, or its driver refuses a shader. Hold
  /// a GlScope, here and below.
  GlSteppedImage(GlContext& context, const SteppedImage& image, const PinholeCamera& camera);
  GlSteppedImage(GlContext& context, const SteppedImage& image, const ReversePinholeCamera& camera);
  GlSteppedImage(GlContext& context, const SteppedImage& image, const SpocCamera& camera);
  GlSteppedImage(GlContext& context, const SteppedImage& image, const DdocCamera& camera);
  GlSteppedImage(GlContext& context, const SteppedImage& image, const EpipolarCamera& camera);

  /// The first crossing of each ray; nothing for rays that are not finite or have no direction.
  GlSteppedHits walk(const GlRays& rays) const;

 private:
  GlSteppedImage(GlContext& context, const SteppedImage& image);
  void setDisplaced(const PinholeCamera& reference, int model, const DisplacementBlock& block);

  GlContext* context_;
  Box bounds_;
  SteppingOptions options_;
  float focalPixels_;
  uint32_t maxIterations_;
  GlObject samples_;
  GlObject colors_;
  GlObject pinhole_;
  GlObject displacement_;
  GlObject distortionMap_;
  std::optional<EpipolarUniforms> epipolar_;
  int imageWidth_;
  GlObject program_;
};

}  // namespace ocelli
