#include "oc_core/gl_rays/gl_refraction.h"

#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/gl_state.h"
#include "oc_core/gl/shaders.h"
#include "oc_core/gl_rays/shaders.h"

namespace ocelli {
namespace {

// As oc_core/shade/secondary_rays.cpp has them.
constexpr int kInnerReflections = 4;
/// What a ray inside begins before the surface that it comes from, of the size of the object.
constexpr float kStepInside = 1e-5f;
/// How far a ray inside reaches, in sizes of the object.
constexpr float kInnerReach = 4;

GlObject glassProgram(GlContext& context, const char* name, std::string_view source) {
  return makeProgram(context, name,
                     {{GL_COMPUTE_SHADER,
                       {shaders::kPinhole, shaders::kMesh, shaders::kFragment, shaders::kSpecularSurface,
                        shaders::kViewRay, source}}});
}

Box boundsOfAll(std::span<const GlassObject> objects) {
  Box box;
  for (const GlassObject& object : objects) {
    for (const glm::vec3& position : object.mesh.positions) {
      box.add(position);
    }
  }
  return box;
}

}  // namespace

GlRefraction::GlRefraction(GlContext& context, std::span<const GlassObject> objects, const RayPictureScene& scene)
    : context_(&context),
      base_(context, scene, boundsOfAll(objects)),
      enter_(glassProgram(context, "glass_enter", shaders::kGlassEnterComp)),
      leave_(glassProgram(context, "glass_leave", shaders::kGlassLeaveComp)) {
  for (const GlassObject& object : objects) {
    OC_CHECK(object.normals.size() == object.mesh.positions.size(), "one normal a vertex");
    const Box box = boundsOf(object.mesh);
    glasses_.push_back({walkOverMesh(context, object.mesh), makeBuffer(context, object.normals), object.refractiveIndex,
                        box.empty() ? 0 : glm::length(box.size())});
  }
}

GlObject GlRefraction::draw(const PinholeCamera& camera) const {
  GlRayPicture::Start start = base_.begin(camera);
  for (const Glass& glass : glasses_) {
    sendThrough(glass, camera, start);
  }
  base_.gather(start.rays, start.picture);
  return std::move(start.picture);
}

void GlRefraction::sendThrough(const Glass& glass, const PinholeCamera& camera,
                               const GlRayPicture::Start& start) const {
  const GladGLContext& gl = context_->gl();
  const int width = camera.width();
  const int height = camera.height();
  const GlFragments seen = base_.draw(camera, glass.walk.mesh());
  const GlRays inner(*context_, width, height);
  const GlObject places = makeTexture(*context_, GL_RGBA32F, width, height);
  const auto bind = [&](const GlObject& program, const GlFragments& fragments) {
    gl.UseProgram(program.id());
    gl.Uniform1f(0, glass.index);
    gl.Uniform1f(1, kStepInside * glass.size);
    gl.Uniform1f(2, kInnerReach * glass.size);
    bindMesh(*context_, glass.walk.mesh());
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, glass.normals.id());
    gl.BindTextureUnit(0, fragments.texture().id());
    gl.BindImageTexture(0, inner.origins().id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    gl.BindImageTexture(1, inner.steps().id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    gl.BindImageTexture(2, places.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  };
  bind(enter_, seen);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, start.pinhole.id());
  gl.BindImageTexture(3, start.nearest.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32F);
  dispatchPixels(*context_, width, height);
  for (int i = 0; i <= kInnerReflections; ++i) {
    const GlRayHits exits = glass.walk.walk(inner);
    bind(leave_, exits.fragments);
    gl.Uniform1f(3, base_.reach());
    gl.Uniform1i(4, i == kInnerReflections ? 1 : 0);
    gl.BindImageTexture(3, start.rays.origins().id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    gl.BindImageTexture(4, start.rays.steps().id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    dispatchPixels(*context_, width, height);
  }
  context_->check("refracting rays");
}

}  // namespace ocelli
