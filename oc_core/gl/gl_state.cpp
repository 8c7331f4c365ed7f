#include "oc_core/gl/gl_state.h"

#include "oc_core/gl/gl_api.h"

namespace ocelli {

void beginDepthDraw(GlContext& context, const GlObject& framebuffer, int width, int height) {
  const GladGLContext& gl = context.gl();
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.id());
  gl.Viewport(0, 0, width, height);
  gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  gl.DepthRangef(0, 1);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_GREATER);
  gl.DepthMask(GL_TRUE);
  gl.Enable(GL_CLIP_DISTANCE0);
  for (const GLenum off : {GL_CULL_FACE, GL_STENCIL_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_FRAMEBUFFER_SRGB}) {
    gl.Disable(off);
  }
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const GLfloat farthest = 0;
  gl.ClearNamedFramebufferfv(framebuffer.id(), GL_DEPTH, 0, &farthest);
}

void bindMesh(GlContext& context, const GlMesh& mesh) {
  const GladGLContext& gl = context.gl();
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, mesh.positions().id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, mesh.triangles().id());
}

void dispatchPixels(GlContext& context, int width, int height) {
  const GladGLContext& gl = context.gl();
  gl.DispatchCompute(static_cast<GLuint>((width + 7) / 8), static_cast<GLuint>((height + 7) / 8), 1);
  gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
}

}  // namespace ocelli
