#include "oc_core/gl_rays/gl_reflection.h"

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

GlRayWalk walkOver(GlContext& context, const Mesh& mesh) {
  const SampleCells cells = triangleCells(mesh);
  return {context, cells, SamplePyramid(cells)};
}

GlObject uploadEnvironment(GlContext& context, const Image<glm::vec3>& image) {
  OC_CHECK(!image.empty(), "an environment map has pixels");
  GlObject texture = makeTexture(context, GL_RGBA32F, image.width(), image.height());
  context.gl().PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  context.gl().TextureSubImage2D(texture.id(), 0, 0, 0, image.width(), image.height(), GL_RGB, GL_FLOAT, image.data());
  context.check("uploading an environment map");
  return texture;
}

/// Long enough to reach everything from anywhere within.
float reachOver(const MirrorScene& scene) {
  Box box;
  for (const Box& part :
       {boundsOf(scene.direct), boundsOf(scene.mirrors), boundsOf(scene.billboards), scene.target.bounds()}) {
    if (!part.empty()) {
      box.add(part.lower);
      box.add(part.upper);
    }
  }
  return box.empty() ? 1 : 1.01f * glm::length(box.size());
}

}  // namespace

GlReflection::GlReflection(GlContext& context, const MirrorScene& scene)
    : context_(&context),
      pinhole_(context),
      direct_(context, scene.direct),
      mirrors_(context, scene.mirrors),
      normals_(makeBuffer(context, scene.normals)),
      cast_(context, scene.target),
      billboards_(walkOver(context, scene.billboards)),
      environment_(uploadEnvironment(context, scene.environment)),
      mirrorRays_(makeProgram(
          context, "mirror_rays",
          {{GL_COMPUTE_SHADER, {shaders::kPinhole, shaders::kMesh, shaders::kFragment, shaders::kMirrorRaysComp}}})),
      gatherRays_(
          makeProgram(context, "gather_rays", {{GL_COMPUTE_SHADER, {shaders::kFragment, shaders::kGatherRaysComp}}})),
      background_(scene.background),
      reach_(reachOver(scene)) {
  OC_CHECK(scene.normals.size() == scene.mirrors.positions.size(), "one normal a vertex");
}

void GlReflection::setTarget(const DepthImageTarget& target) {
  cast_.setTarget(target.cells(), target.pyramid());
}

GlObject GlReflection::draw(const PinholeCamera& camera) const {
  const GladGLContext& gl = context_->gl();
  const int width = camera.width();
  const int height = camera.height();
  const GlFragments direct = pinhole_.draw(camera, direct_);
  const GlFragments mirrors = pinhole_.draw(camera, mirrors_);
  const GlObject uniforms = pinholeUniforms(*context_, camera);
  const GlRays rays(*context_, width, height);
  GlObject picture = makeTexture(*context_, GL_RGBA32F, width, height);
  gl.UseProgram(mirrorRays_.id());
  gl.Uniform3f(0, background_.x, background_.y, background_.z);
  gl.Uniform1f(1, reach_);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms.id());
  bindMesh(*context_, mirrors_);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, normals_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, direct_.triangles().id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, direct_.colors().id());
  gl.BindTextureUnit(0, direct.texture().id());
  gl.BindTextureUnit(1, mirrors.texture().id());
  gl.BindImageTexture(0, rays.origins().id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  gl.BindImageTexture(1, rays.steps().id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  gl.BindImageTexture(2, picture.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  dispatchPixels(*context_, width, height);
  context_->check("reflecting rays");

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
  dispatchPixels(*context_, width, height);
  context_->check("gathering what rays see");
  return picture;
}

}  // namespace ocelli
