#include "oc_core/window/screen_target.h"

#include <array>

#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_image.h"

namespace ocelli {

void ScreenTarget::resize(int width, int height) {
  if (framebuffer_ && width == width_ && height == height_) {
    return;
  }
  framebuffer_ = GlObject();
  color_ = makeTexture(*context_, GL_RGBA8, width, height);
  framebuffer_ = makeFramebuffer(*context_, std::array{color_.id()}, 0);
  width_ = width;
  height_ = height;
}

void ScreenTarget::clear(GuiColor color) {
  const GladGLContext& gl = context_->gl();
  const auto [red, green, blue] = color.floats();
  const std::array<float, 4> rgba{red, green, blue, 1};
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_FRAMEBUFFER_SRGB);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.ClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 0, rgba.data());
}

void ScreenTarget::bind() {
  context_->gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
}

Image<Rgb8> ScreenTarget::read() const {
  return readRgb8(*context_, color_, width_, height_);
}

}  // namespace ocelli
