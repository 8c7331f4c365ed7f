#include "oc_core/gl_rays/gl_reflection.h"

#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/gl_state.h"
#include "oc_core/gl/shaders.h"
#include "oc_core/gl_rays/shaders.h"

namespace ocelli {

GlReflection::GlReflection(GlContext& context, const Mesh& mirrors, std::span<const glm::vec3> normals,
                           const RayPictureScene& scene)
    : context_(&context),
      base_(context, scene, boundsOf(mirrors)),
      mirrors_(context, mirrors),
      normals_(makeBuffer(context, normals)),
      mirrorRays_(makeProgram(context, "mirror_rays",
                              {{GL_COMPUTE_SHADER,
                                {shaders::kPinhole, shaders::kMesh, shaders::kFragment, shaders::kSpecularSurface,
                                 shaders::kViewRay, shaders::kMirrorRaysComp}}})) {
  OC_CHECK(normals.size() == mirrors.positions.size(), "one normal a vertex");
}

GlObject GlReflection::draw(const PinholeCamera& camera) const {
  const GladGLContext& gl = context_->gl();
  GlRayPicture::Start start = base_.begin(camera);
  const GlFragments mirrors = base_.draw(camera, mirrors_);
  gl.UseProgram(mirrorRays_.id());
  gl.Uniform1f(0, base_.reach());
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, start.pinhole.id());
  bindMesh(*context_, mirrors_);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, normals_.id());
  gl.BindTextureUnit(0, mirrors.texture().id());
  gl.BindImageTexture(0, start.rays.origins().id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  gl.BindImageTexture(1, start.rays.steps().id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  gl.BindImageTexture(3, start.nearest.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32F);
  dispatchPixels(*context_, camera.width(), camera.height());
  context_->check("reflecting rays");
  base_.gather(start.rays, start.picture);
  return std::move(start.picture);
}

}  // namespace ocelli
