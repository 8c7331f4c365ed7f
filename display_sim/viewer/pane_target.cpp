#include "display_sim/viewer/pane_target.h"

#include <array>

#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_image.h"

namespace ocelli {

void PaneTarget::begin(int width, int height, const glm::vec3& background) {
  const GladGLContext& gl = context_->gl();
  if (width != width_ || height != height_ || !framebuffer_) {
    framebuffer_ = GlObject();
    color_ = makeTexture(*context_, GL_RGBA8, width, height);
    depth_ = makeTexture(*context_, GL_DEPTH_COMPONENT32F, width, height);
    std::vector<uint32_t> colors{color_.id()};
    if (holds_ == Holds::kColorAndPoints) {
      points_ = makeTexture(*context_, GL_RGBA32F, width, height);
      colors.push_back(points_.id());
    }
    framebuffer_ = makeFramebuffer(*context_, colors, depth_.id());
    width_ = width;
    height_ = height;
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl.Viewport(0, 0, width, height);
  for (const GLenum off : {GL_CULL_FACE, GL_STENCIL_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_FRAMEBUFFER_SRGB}) {
    gl.Disable(off);
  }
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.DepthMask(GL_TRUE);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  const std::array<float, 4> clearColor{background.x, background.y, background.z, 1};
  gl.ClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 0, clearColor.data());
  if (holds_ == Holds::kColorAndPoints) {
    const std::array<float, 4> nothing{0, 0, 0, 0};
    gl.ClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 1, nothing.data());
  }
  const float farthest = 1;
  gl.ClearNamedFramebufferfv(framebuffer_.id(), GL_DEPTH, 0, &farthest);
}

Image<Rgb8> PaneTarget::read() const {
  return readRgb8(*context_, color_, width_, height_);
}

}  // namespace ocelli
