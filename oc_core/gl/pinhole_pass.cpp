#include "oc_core/gl/pinhole_pass.h"

#include <array>

#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/gl_state.h"
#include "oc_core/gl/pinhole_uniforms.h"
#include "oc_core/gl/shaders.h"

namespace ocelli {

PinholePass::PinholePass(GlContext& context)
    : context_(context),
      visibility_(makeProgram(context, "pinhole_visibility",
                              {{GL_VERTEX_SHADER, {shaders::kPinhole, shaders::kPinholeVisibilityVert}},
                               {GL_FRAGMENT_SHADER, {shaders::kPinholeVisibilityFrag}}})),
      resolve_(makeProgram(context, "pinhole_resolve",
                           {{GL_COMPUTE_SHADER,
                             {shaders::kPinhole, shaders::kMesh, shaders::kFragment, shaders::kWeights,
                              shaders::kPinholeResolveComp}}})) {}

GlFragments PinholePass::draw(const PinholeCamera& camera, const GlMesh& mesh) const {
  const GladGLContext& gl = context_.gl();
  const GlObject uniforms = pinholeUniforms(context_, camera);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms.id());

  const GlObject visible = makeTexture(context_, GL_R32UI, camera.width(), camera.height());
  const GlObject depth = makeTexture(context_, GL_DEPTH_COMPONENT32F, camera.width(), camera.height());
  const GlObject framebuffer = makeFramebuffer(context_, std::array{visible.id()}, depth.id());
  beginDepthDraw(context_, framebuffer, camera.width(), camera.height());
  gl.ClearNamedFramebufferuiv(framebuffer.id(), GL_COLOR, 0, std::array{Fragment::kNoTriangle, 0u, 0u, 0u}.data());
  gl.UseProgram(visibility_.id());
  gl.BindVertexArray(mesh.vertexArray().id());
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * mesh.triangleCount()), GL_UNSIGNED_INT, nullptr);

  GlFragments fragments(context_, camera.width(), camera.height());
  gl.UseProgram(resolve_.id());
  bindMesh(context_, mesh);
  gl.BindTextureUnit(0, visible.id());
  gl.BindImageTexture(0, fragments.texture().id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32UI);
  dispatchPixels(context_, camera.width(), camera.height());
  context_.check("drawing what the pinhole sees");
  return fragments;
}

}  // namespace ocelli
