// An image from the CPU as a texture: to be copied into a rectangle of the window, or drawn by panels.
#pragma once

#include <glm/vec2.hpp>

#include "oc_core/gl/gl_object.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

class ImageTexture {
 public:
  /// Hold a GlScope, here and below.
  void upload(GlContext& context, const Image<Rgb8>& image);
  /// Into a rectangle of a framebuffer, pixels from the top left; scaled where it is of another size.
  void copyTo(GlContext& context, const GlObject& framebuffer, const glm::ivec2& corner, const glm::ivec2& size) const;

  const GlObject& texture() const { return texture_; }
  const glm::ivec2& size() const { return size_; }
  explicit operator bool() const { return static_cast<bool>(texture_); }

 private:
  GlObject texture_;
  GlObject framebuffer_;
  glm::ivec2 size_{0};
};

}  // namespace ocelli
