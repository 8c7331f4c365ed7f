#include "oc_core/gl_rays/gl_ray_picture.h"

#include <glm/geometric.hpp>

#include "oc_core/base/check.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/gl_state.h"
#include "oc_core/gl/pinhole_uniforms.h"
#include "oc_core/gl/shaders.h"
#include "oc_core/gl_rays/shaders.h"

namespace ocelli {
namespace {

GlObject uploadEnvironment(GlContext& context, const Image<glm::vec3>& image) {
  OC_CHECK(!image.empty(), "an environment map has pixels");
  GlObject texture = makeTexture(context, GL_RGBA32F, image.width(), image.height());
  context.gl().PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  context.gl().TextureSubImage2D(texture.id(), 0, 0, 0, image.width(), image.height(), GL_RGB, GL_FLOAT, image.data());
  context.check("uploading an environment map");
  return texture;
}

/// The diagonal of everything, and a little more.
float reachOver(const RayPictureScene& scene, const Box& senders) {
  Box box;
  for (const Box& part : {boundsOf(scene.direct), senders, boundsOf(scene.billboards), scene.target.bounds()}) {
    if (!part.empty()) {
      box.add(part.lower);
      box.add(part.upper);
    }
  }
  return box.empty() ? 1 : 1.01f * glm::length(box.size());
}

}  // namespace

GlRayWalk walkOverMesh(GlContext& context, const Mesh& mesh) {
  const SampleCells cells = triangleCells(mesh);
  return {context, cells, SamplePyramid(cells)};
}

GlRayPicture::GlRayPicture(GlContext& context, const RayPictureScene& scene, const Box& senders)
    : context_(&context),
      pinhole_(context),
      direct_(context, scene.direct),
      cast_(context, scene.target),
      billboards_(walkOverMesh(context, scene.billboards)),
      environment_(uploadEnvironment(context, scene.environment)),
      directPicture_(
          makeProgram(context, "direct_picture",
                      {{GL_COMPUTE_SHADER, {shaders::kMesh, shaders::kFragment, shaders::kDirectPictureComp}}})),
      gatherRays_(
          makeProgram(context, "gather_rays", {{GL_COMPUTE_SHADER, {shaders::kFragment, shaders::kGatherRaysComp}}})),
      background_(scene.background),
      reach_(reachOver(scene, senders)) {}

void GlRayPicture::setTarget(const DepthImageTarget& target) {
  cast_.setTarget(target.cells(), target.pyramid());
}

GlRayPicture::Start GlRayPicture::begin(const PinholeCamera& camera) const {
  const GladGLContext& gl = context_->gl();
  const int width = camera.width();
  const int height = camera.height();
  const GlFragments direct = pinhole_.draw(camera, direct_);
  Start start{makeTexture(*context_, GL_RGBA32F, width, height), makeTexture(*context_, GL_R32F, width, height),
              GlRays(*context_, width, height), pinholeUniforms(*context_, camera)};
  gl.UseProgram(directPicture_.id());
  gl.Uniform3f(0, background_.x, background_.y, background_.z);
  bindMesh(*context_, direct_);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, direct_.colors().id());
  gl.BindTextureUnit(0, direct.texture().id());
  gl.BindImageTexture(0, start.rays.origins().id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  gl.BindImageTexture(1, start.rays.steps().id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  gl.BindImageTexture(2, start.picture.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  gl.BindImageTexture(3, start.nearest.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
  dispatchPixels(*context_, width, height);
  context_->check("drawing what is seen at once");
  return start;
}

void GlRayPicture::gather(const GlRays& rays, const GlObject& picture) const {
  const GladGLContext& gl = context_->gl();
  const GlRayHits cast = cast_.walk(rays);
  const GlRayHits billboards = billboards_.walk(rays);
  gl.UseProgram(gatherRays_.id());
  gl.BindTextureUnit(0, rays.steps().id());
  gl.BindTextureUnit(1, cast.fragments.texture().id());
  gl.BindTextureUnit(2, cast.colors.id());
  gl.BindTextureUnit(3, billboards.fragments.texture().id());
  gl.BindTextureUnit(4, billboards.colors.id());
  gl.BindTextureUnit(5, environment_.id());
  gl.BindImageTexture(0, picture.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  dispatchPixels(*context_, rays.width(), rays.height());
  context_->check("gathering what rays see");
}

}  // namespace ocelli
