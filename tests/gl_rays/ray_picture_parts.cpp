#include "tests/gl_rays/ray_picture_parts.h"

#include <gtest/gtest.h>

#include "oc_core/gl/gl_api.h"

namespace ocelli::test {

Image<glm::vec3> readPicture(GlContext& context, const GlObject& picture, const PinholeCamera& camera) {
  const auto pixels = readTexture<glm::vec4>(context, picture, camera.width(), camera.height(), GL_RGBA, GL_FLOAT);
  Image<glm::vec3> image(camera.width(), camera.height());
  for (size_t i = 0; i < pixels.size(); ++i) {
    EXPECT_EQ(pixels[i].w, 1);
    image[i] = glm::vec3(pixels[i]);
  }
  return image;
}

}  // namespace ocelli::test
