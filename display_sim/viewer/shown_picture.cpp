#include "display_sim/viewer/shown_picture.h"

#include <array>

#include "display_sim/viewer/viewer_colors.h"
#include "oc_core/gl/gl_api.h"

namespace ocelli {

ReconstructionPane::Place picturePlace(const ViewerState& state, const glm::ivec2& paneSize) {
  return placesBeside(paneSize, static_cast<double>(state.work.width) / state.work.height, 1).front();
}

void ShownPicture::upload(const Image<Rgb8>& picture) {
  const GladGLContext& gl = context_->gl();
  const glm::ivec2 size(picture.width(), picture.height());
  if (size != textureSize_ || !framebuffer_) {
    framebuffer_ = GlObject();
    texture_ = GlObject();
    texture_ = makeTexture(*context_, GL_RGBA8, size.x, size.y);
    framebuffer_ = makeFramebuffer(*context_, std::array{texture_.id()}, 0);
    textureSize_ = size;
  }
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TextureSubImage2D(texture_.id(), 0, 0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, picture.data());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  context_->check("uploading a picture");
}

void ShownPicture::draw(const Image<Rgb8>* picture, const ReconstructionPane::Place& place,
                        const glm::ivec2& paneSize) {
  if (picture != nullptr) {
    upload(*picture);
  }
  target_.begin(paneSize.x, paneSize.y, rgb(kPaneColor));
  if (picture != nullptr) {
    const GLenum filter = textureSize_ == place.size ? GL_NEAREST : GL_LINEAR;
    const glm::ivec2 end = place.corner + place.size;
    context_->gl().BlitNamedFramebuffer(framebuffer_.id(), target_.framebuffer().id(), 0, 0, textureSize_.x,
                                        textureSize_.y, place.corner.x, place.corner.y, end.x, end.y,
                                        GL_COLOR_BUFFER_BIT, filter);
    context_->check("showing a picture");
  }
}

}  // namespace ocelli
