// A fragment image (oc_core/render/fragment_image.h) in the memory of the GPU: one GL_RGBA32UI texel a pixel, row 0 at
// the top, with the bits of z, the triangle, and the bits of b1 and b2.
#pragma once

#include "oc_core/gl/gl_object.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli {

class GlFragments {
 public:
  /// What it holds is undefined. Hold a GlScope, here and below.
  GlFragments(GlContext& context, int width, int height);
  GlFragments(GlContext& context, const FragmentImage& fragments);

  const GlObject& texture() const { return texture_; }
  int width() const { return width_; }
  int height() const { return height_; }

  /// Empties every pixel.
  void clear();
  FragmentImage read() const;

 private:
  GlContext* context_;
  int width_;
  int height_;
  GlObject texture_;
};

}  // namespace ocelli
