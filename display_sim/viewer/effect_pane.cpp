#include "display_sim/viewer/effect_pane.h"

#include <array>

#include "display_sim/viewer/viewer_colors.h"
#include "oc_core/gl/gl_api.h"

namespace ocelli {

ReconstructionPane::Place effectPlace(const ViewerState& state, const glm::ivec2& paneSize) {
  return placesBeside(paneSize, static_cast<double>(state.work.width) / state.work.height, 1).front();
}

void EffectPane::upload(const Image<Rgb8>& image) {
  const GladGLContext& gl = context_->gl();
  framebuffer_ = GlObject();
  texture_ = GlObject();
  texture_ = makeTexture(*context_, GL_RGBA8, image.width(), image.height());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TextureSubImage2D(texture_.id(), 0, 0, 0, image.width(), image.height(), GL_RGB, GL_UNSIGNED_BYTE, image.data());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  framebuffer_ = makeFramebuffer(*context_, std::array{texture_.id()}, 0);
  context_->check("uploading the picture of an effect");
}

bool EffectPane::draw(const ViewerState& state, const EffectStatus& status, const glm::ivec2& size) {
  const ReconstructionPane::Place place = effectPlace(state, size);
  const Key key{status.picture, state.effect.content, size, place.size};
  if (key == drawn_) {
    return false;
  }
  drawn_ = key;
  const Image<Rgb8>* image = status.picture ? status.picture->shown(state.effect.content) : nullptr;
  if (image != nullptr) {
    upload(*image);
  }
  target_.begin(size.x, size.y, rgb(kPaneColor));
  if (image != nullptr) {
    const GLenum filter = glm::ivec2(image->width(), image->height()) == place.size ? GL_NEAREST : GL_LINEAR;
    const glm::ivec2 end = place.corner + place.size;
    context_->gl().BlitNamedFramebuffer(framebuffer_.id(), target_.framebuffer().id(), 0, 0, image->width(),
                                        image->height(), place.corner.x, place.corner.y, end.x, end.y,
                                        GL_COLOR_BUFFER_BIT, filter);
    context_->check("showing the picture of an effect");
  }
  return true;
}

}  // namespace ocelli
