#include "oc_core/gl/gl_image.h"

#include <array>

#include "oc_core/gl/gl_api.h"

namespace ocelli {

Image<Rgb8> readRgb8(GlContext& context, const GlObject& texture, int width, int height) {
  using Rgba8 = std::array<uint8_t, 4>;
  const auto pixels = readTexture<Rgba8>(context, texture, width, height, GL_RGBA, GL_UNSIGNED_BYTE);
  Image<Rgb8> image(width, height);
  for (size_t i = 0; i < pixels.size(); ++i) {
    image[i] = {pixels[i][0], pixels[i][1], pixels[i][2]};
  }
  return image;
}

}  // namespace ocelli
