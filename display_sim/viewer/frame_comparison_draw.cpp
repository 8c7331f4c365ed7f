#include "display_sim/viewer/frame_comparison_draw.h"

#include <array>
#include <glm/geometric.hpp>

#include "display_sim/viewer/shaders.h"
#include "display_sim/viewer/viewer_colors.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"

namespace ocelli {
namespace {

constexpr GLint kMissingLocation = 0;  // of marks_fragment.glsl
constexpr GLint kMissingThickLocation = 1;
constexpr GLint kMissingEye = 0;  // of missing_fragment.glsl
constexpr GLint kMissingForward = 3;
constexpr GLint kReachPerDepth = 7;

void setColor(const GladGLContext& gl, const GlObject& program, GLint location, const glm::vec3& color) {
  gl.ProgramUniform3f(program.id(), location, color.x, color.y, color.z);
}

}  // namespace

FrameComparisonDraw::FrameComparisonDraw(GlContext& context)
    : context_(&context),
      truth_(context, PaneTarget::Holds::kColorAndPoints),
      frame_(context, PaneTarget::Holds::kColorAndPoints),
      marked_(context),
      missingProgram_(makeProgram(
          context, "missing samples",
          {{GL_VERTEX_SHADER, {shaders::kScreenVertex}}, {GL_FRAGMENT_SHADER, {shaders::kMissingFragment}}})),
      marksProgram_(
          makeProgram(context, "marks of missing samples",
                      {{GL_VERTEX_SHADER, {shaders::kScreenVertex}}, {GL_FRAGMENT_SHADER, {shaders::kMarksFragment}}})),
      vertexArray_(makeVertexArray(context)) {
  setColor(context.gl(), marksProgram_, kMissingLocation, rgb(kMissingGui));
  setColor(context.gl(), marksProgram_, kMissingThickLocation, rgb(kMissingThickGui));
}

MissingSamples FrameComparisonDraw::draw(const GlMesh& truth, const GlMesh& frame, const Box& bounds,
                                         const PinholeCamera& camera, const glm::vec3& background, MeshDraw& meshes) {
  const DepthRange range = depthRange(camera, bounds);
  truth_.begin(camera.width(), camera.height(), background);
  meshes.draw(truth, camera, range);
  frame_.begin(camera.width(), camera.height(), background);
  meshes.draw(frame, camera, range);
  markMissing(camera);
  return shade({camera.width(), camera.height()});
}

void FrameComparisonDraw::markMissing(const PinholeCamera& camera) {
  const GladGLContext& gl = context_->gl();
  const glm::ivec2 size(camera.width(), camera.height());
  if (size != statesSize_) {
    statesFramebuffer_ = GlObject();
    states_ = makeTexture(*context_, GL_R8UI, size.x, size.y);
    statesFramebuffer_ = makeFramebuffer(*context_, std::array{states_.id()}, 0);
    statesSize_ = size;
  }
  const glm::vec3& eye = camera.eye();
  const glm::vec3 forward = glm::normalize(camera.view().target - eye);
  gl.ProgramUniform3f(missingProgram_.id(), kMissingEye, eye.x, eye.y, eye.z);
  gl.ProgramUniform3f(missingProgram_.id(), kMissingForward, forward.x, forward.y, forward.z);
  gl.ProgramUniform1f(missingProgram_.id(), kReachPerDepth, kNearFootprints / camera.focalPixels());
  gl.BindFramebuffer(GL_FRAMEBUFFER, statesFramebuffer_.id());
  gl.Viewport(0, 0, size.x, size.y);
  gl.Disable(GL_DEPTH_TEST);
  gl.UseProgram(missingProgram_.id());
  gl.BindVertexArray(vertexArray_.id());
  const std::array<GLuint, 2> points{truth_.points().id(), frame_.points().id()};
  gl.BindTextures(0, points.size(), points.data());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  context_->check("comparing with the truth");
}

MissingSamples FrameComparisonDraw::shade(const glm::ivec2& size) {
  const GladGLContext& gl = context_->gl();
  const std::array<uint32_t, 3> zeros{};
  const GlObject counts = makeBuffer(*context_, sizeof(zeros), zeros.data());
  marked_.begin(size.x, size.y, glm::vec3(0));
  gl.Disable(GL_DEPTH_TEST);
  gl.UseProgram(marksProgram_.id());
  gl.BindVertexArray(vertexArray_.id());
  const std::array<GLuint, 2> textures{states_.id(), frame_.color().id()};
  gl.BindTextures(0, textures.size(), textures.data());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, counts.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  std::array<uint32_t, 3> found{};
  readBuffer(*context_, counts, sizeof(found), found.data());
  return {found[0], found[1], found[2]};
}

}  // namespace ocelli
