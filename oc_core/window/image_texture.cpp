#include "oc_core/window/image_texture.h"

#include <array>

#include "oc_core/gl/gl_api.h"

namespace ocelli {

void ImageTexture::upload(GlContext& context, const Image<Rgb8>& image) {
  const GladGLContext& gl = context.gl();
  const glm::ivec2 size(image.width(), image.height());
  if (size != size_ || !framebuffer_) {
    framebuffer_ = GlObject();
    texture_ = makeTexture(context, GL_RGBA8, size.x, size.y);
    gl.TextureParameteri(texture_.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TextureParameteri(texture_.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    framebuffer_ = makeFramebuffer(context, std::array{texture_.id()}, 0);
    size_ = size;
  }
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TextureSubImage2D(texture_.id(), 0, 0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, image.data());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  context.check("uploading an image");
}

void ImageTexture::copyTo(GlContext& context, const GlObject& framebuffer, const glm::ivec2& corner,
                          const glm::ivec2& size) const {
  const GladGLContext& gl = context.gl();
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_FRAMEBUFFER_SRGB);
  gl.BlitNamedFramebuffer(framebuffer_.id(), framebuffer.id(), 0, 0, size_.x, size_.y, corner.x, corner.y,
                          corner.x + size.x, corner.y + size.y, GL_COLOR_BUFFER_BIT,
                          size == size_ ? GL_NEAREST : GL_LINEAR);
  context.check("showing an image");
}

}  // namespace ocelli
