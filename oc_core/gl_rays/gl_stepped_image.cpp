#include "oc_core/gl_rays/gl_stepped_image.h"

#include <algorithm>
#include <array>
#include <glm/vec4.hpp>
#include <string>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/gl_state.h"
#include "oc_core/gl/pinhole_uniforms.h"
#include "oc_core/gl/shaders.h"
#include "oc_core/gl_rays/shaders.h"

namespace ocelli {
namespace {

/// Software renderers end a shader after 65535 iterations of its loops, all together, and say nothing.
constexpr uint32_t kSoftwareIterations = 65000;

uint32_t iterationsWithin(const GlContext& context, uint32_t ofProjection) {
  return context.info().isSoftware ? kSoftwareIterations / (1 + ofProjection) : 0xffffffffu;
}

std::string steppingDefines() {
  return "#define MAX_HALVINGS " + std::to_string(SteppedImage::kMaxHalvings) + "\n#define ALWAYS_HALVED " +
         std::to_string(SteppedImage::kAlwaysHalved) + "\n#define UNSEEN_HALVINGS " +
         std::to_string(SteppedImage::kUnseenHalvings) + "\n#define CLEARLY double(" +
         std::to_string(SteppedImage::kClearly) + ")\n";
}

/// `projection` are pieces of GLSL that make project().
GlObject steppedProgram(GlContext& context, std::vector<std::string_view> projection, const std::string& defines) {
  projection.insert(projection.end(), {shaders::kFragment, shaders::kStraightRay, shaders::kSteppedWalkComp});
  return makeProgram(context, "stepped_walk", {{GL_COMPUTE_SHADER, projection}}, steppingDefines() + defines);
}

/// The most disocclusions over a cell.
uint32_t longestList(const EpipolarCamera& camera) {
  size_t longest = 0;
  for (int row = 0; row < camera.height(); ++row) {
    for (int cell = 0; cell < camera.cellCount(row); ++cell) {
      longest = std::max(longest, camera.disocclusionsOver(row, cell).size());
    }
  }
  return static_cast<uint32_t>(longest);
}

}  // namespace

GlSteppedImage::GlSteppedImage(GlContext& context, const SteppedImage& image)
    : context_(&context),
      bounds_(image.bounds()),
      options_(image.options()),
      focalPixels_(image.focalPixels()),
      maxIterations_(iterationsWithin(context, 0)),
      samples_(makeTexture(context, GL_RG32F, image.image().width(), image.image().height())),
      colors_(makeTexture(context, GL_RGBA32F, image.image().width(), image.image().height())),
      imageWidth_(image.image().width()) {
  const ReferenceImage& from = image.image();
  Image<glm::vec2> samples(from.width(), from.height(), glm::vec2(0));
  constexpr size_t kRows = 8;
  parallelFor(static_cast<size_t>(from.height()), kRows, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const auto y = static_cast<int>(row);
      for (int x = 0; x < from.width(); ++x) {
        if (from.holds(x, y)) {
          samples(x, y) = {from.t(x, y), static_cast<float>(image.opacityOf(x, y))};
        }
      }
    }
  });
  const GladGLContext& gl = context.gl();
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TextureSubImage2D(samples_.id(), 0, 0, 0, from.width(), from.height(), GL_RG, GL_FLOAT, samples.data());
  gl.TextureSubImage2D(colors_.id(), 0, 0, 0, from.width(), from.height(), GL_RGB, GL_FLOAT, from.color.data());
  context.check("uploading a reference image");
}

GlSteppedImage::GlSteppedImage(GlContext& context, const SteppedImage& image, const PinholeCamera& camera)
    : GlSteppedImage(context, image) {
  pinhole_ = pinholeUniforms(context, camera);
  program_ = steppedProgram(context, {shaders::kPinhole, shaders::kDisplacedProject}, "#define MODEL 0\n");
}

GlSteppedImage::GlSteppedImage(GlContext& context, const SteppedImage& image, const ReversePinholeCamera& camera)
    : GlSteppedImage(context, image) {
  setDisplaced(camera.reference(), kReversePinholeModel, displacementBlock(camera));
}

GlSteppedImage::GlSteppedImage(GlContext& context, const SteppedImage& image, const SpocCamera& camera)
    : GlSteppedImage(context, image) {
  setDisplaced(camera.reference(), kSpocModel, displacementBlock(camera));
}

GlSteppedImage::GlSteppedImage(GlContext& context, const SteppedImage& image, const DdocCamera& camera)
    : GlSteppedImage(context, image) {
  distortionMap_ = distortionTexture(context, camera);
  setDisplaced(camera.reference(), kDdocModel, displacementBlock(camera));
}

GlSteppedImage::GlSteppedImage(GlContext& context, const SteppedImage& image, const EpipolarCamera& camera)
    : GlSteppedImage(context, image) {
  OC_CHECK(camera.width() == imageWidth_, "the image is one of the camera");
  constexpr uint32_t kSearch = 33;  // iterations to find an edge of a row
  maxIterations_ = iterationsWithin(context, kSearch + longestList(camera) + 1);
  epipolar_.emplace(context, camera);
  program_ = steppedProgram(
      context, {shaders::kPinhole, shaders::kEpipolarLines, shaders::kEpipolarDisocclusions, shaders::kEpipolarProject},
      "");
}

void GlSteppedImage::setDisplaced(const PinholeCamera& reference, int model, const DisplacementBlock& block) {
  pinhole_ = pinholeUniforms(*context_, reference);
  displacement_ = makeBuffer(*context_, sizeof(block), &block);
  program_ = steppedProgram(*context_, {shaders::kPinhole, shaders::kDisplaced, shaders::kDisplacedProject},
                            displacementDefine(model));
}

GlSteppedHits GlSteppedImage::walk(const GlRays& rays) const {
  const GladGLContext& gl = context_->gl();
  GlSteppedHits found{makeTexture(*context_, GL_RGBA32F, rays.width(), rays.height()),
                      makeTexture(*context_, GL_RGBA32F, rays.width(), rays.height()),
                      makeTexture(*context_, GL_RGBA32UI, rays.width(), rays.height())};
  gl.UseProgram(program_.id());
  // Bounds of nothing are met by no ray.
  gl.Uniform3f(0, bounds_.lower.x, bounds_.lower.y, bounds_.lower.z);
  gl.Uniform3f(1, bounds_.upper.x, bounds_.upper.y, bounds_.upper.z);
  gl.Uniform1f(2, static_cast<float>(options_.coarsePixels));
  gl.Uniform1f(3, static_cast<float>(options_.finePixels));
  gl.Uniform1f(4, static_cast<float>(options_.joinFootprints));
  gl.Uniform1f(5, focalPixels_);
  gl.Uniform1ui(6, maxIterations_);
  if (epipolar_) {
    gl.Uniform1i(8, imageWidth_);
    epipolar_->bind(*context_);
  } else {
    gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, pinhole_.id());
  }
  if (displacement_) {
    gl.BindBufferBase(GL_UNIFORM_BUFFER, 1, displacement_.id());
  }
  if (distortionMap_) {
    gl.BindTextureUnit(1, distortionMap_.id());
  }
  gl.BindTextureUnit(0, rays.origins().id());
  gl.BindTextureUnit(3, rays.steps().id());
  gl.BindTextureUnit(4, samples_.id());
  gl.BindTextureUnit(5, colors_.id());
  gl.BindImageTexture(0, found.hits.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  gl.BindImageTexture(1, found.colors.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  gl.BindImageTexture(2, found.costs.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32UI);
  dispatchPixels(*context_, rays.width(), rays.height());
  context_->check("stepping along rays");
  return found;
}

}  // namespace ocelli
