#include "study/screen/screen_target.h"

#include <array>

#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_image.h"

namespace ocelli {

ScreenTarget::ScreenTarget(GlContext& context, int width, int height)
    : context_(&context),
      width_(width),
      height_(height),
      color_(makeTexture(context, GL_RGBA8, width, height)),
      framebuffer_(makeFramebuffer(context, std::array{color_.id()}, 0)) {}

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
