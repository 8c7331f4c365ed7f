#include "display_sim/viewer/reference_pane.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "display_sim/viewer/shaders.h"
#include "display_sim/viewer/viewer_colors.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/shaders.h"

namespace ocelli {
namespace {

enum : GLint {  // locations of the fragment shader
  kFirstPixel,
  kPixelStep,
  kQuantity,
  kDepthRange,
  kLongestDisplacement,
  kPickedPixel,
  kBackground,
  kReferenceHeight
};

template <class Pixel>
GlObject uploaded(GlContext& context, GLenum internalFormat, GLenum format, const Image<Pixel>& image) {
  const GladGLContext& gl = context.gl();
  GlObject texture = makeTexture(context, internalFormat, image.width(), image.height());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TextureSubImage2D(texture.id(), 0, 0, 0, image.width(), image.height(), format, GL_FLOAT, image.data());
  context.check("uploading the reference image");
  return texture;
}

}  // namespace

ReferenceScale scaleOf(const ReferenceImage& image) {
  ReferenceScale scale{1e30f, 0, 0};
  for (size_t i = 0; i < image.t.size(); ++i) {
    if (image.holds(i)) {
      scale.nearest = std::min(scale.nearest, image.t[i]);
      scale.farthest = std::max(scale.farthest, image.t[i]);
      scale.longestDisplacement = std::max(scale.longestDisplacement, glm::length(image.displacement[i]));
    }
  }
  return scale.farthest > 0 ? scale : ReferenceScale{};
}

ReferencePane::ReferencePane(GlContext& context)
    : context_(&context),
      target_(context),
      program_(makeProgram(context, "reference image",
                           {{GL_VERTEX_SHADER, {shaders::kScreenVertex}},
                            {GL_FRAGMENT_SHADER, {shaders::kEncode, shaders::kReferenceFragment}}})),
      vertexArray_(makeVertexArray(context)) {}

void ReferencePane::upload(const ReferenceImage& image) {
  colors_ = uploaded(*context_, GL_RGB16F, GL_RGB, image.color);
  depths_ = uploaded(*context_, GL_R32F, GL_RED, image.t);
  displacements_ = uploaded(*context_, GL_RG32F, GL_RG, image.displacement);
  scale_ = scaleOf(image);
}

bool ReferencePane::draw(const ViewerState& state, const ViewerData& data, const std::optional<glm::ivec2>& picked,
                         const glm::ivec2& size) {
  const Key key{state.reference, data.version, picked, size};
  if (key == drawn_) {
    return false;
  }
  drawn_ = key;
  const GladGLContext& gl = context_->gl();
  target_.begin(size.x, size.y, rgb(kPaneColor));
  const ReferenceImage* image = shownImage(state, data);
  if (image == nullptr) {
    scale_ = {};
    return true;
  }
  if (data.version != uploadedVersion_ || state.reference.image != uploadedImage_) {
    upload(*image);
    uploadedVersion_ = data.version;
    uploadedImage_ = state.reference.image;
  }
  const ImagePlacement placement = placeImage(state.reference, {image->width(), image->height()}, size);
  const GLuint program = program_.id();
  gl.ProgramUniform2f(program, kFirstPixel, placement.firstPixel.x, placement.firstPixel.y);
  gl.ProgramUniform1f(program, kPixelStep, placement.pixelStep);
  gl.ProgramUniform1i(program, kQuantity, static_cast<GLint>(state.reference.quantity));
  gl.ProgramUniform2f(program, kDepthRange, scale_.nearest, scale_.farthest);
  gl.ProgramUniform1f(program, kLongestDisplacement, scale_.longestDisplacement);
  const glm::ivec2 pixel = picked.value_or(glm::ivec2(-1));
  gl.ProgramUniform2i(program, kPickedPixel, pixel.x, pixel.y);
  const glm::vec3 background = rgb(kPaneColor);
  gl.ProgramUniform3f(program, kBackground, background.x, background.y, background.z);
  gl.ProgramUniform1i(program, kReferenceHeight,
                      image->pinholeSize.y > 0 && image->tileSide > 0 ? image->pinholeSize.y : image->height());
  gl.Disable(GL_DEPTH_TEST);
  gl.UseProgram(program);
  gl.BindVertexArray(vertexArray_.id());
  const std::array<GLuint, 3> textures{colors_.id(), depths_.id(), displacements_.id()};
  gl.BindTextures(0, textures.size(), textures.data());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  context_->check("drawing the reference image");
  return true;
}

const ReferenceImage* shownImage(const ViewerState& state, const ViewerData& data) {
  if (!data.camera || static_cast<size_t>(state.reference.image) >= data.camera->representation.images.size()) {
    return nullptr;
  }
  return &data.camera->representation.images[static_cast<size_t>(state.reference.image)];
}

}  // namespace ocelli
