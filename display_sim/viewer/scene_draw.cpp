#include "display_sim/viewer/scene_draw.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "display_sim/viewer/shaders.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/shaders.h"

namespace ocelli {
namespace {

// Locations of view.glsl and of the shaders that use it.
enum : GLint { kEye, kRight, kDown, kForward, kScale, kCenter, kRange, kPointPixels, kPaneSize = 7, kOpacity };

void setVector(const GladGLContext& gl, const GlObject& program, GLint location, const glm::vec3& v) {
  gl.ProgramUniform3f(program.id(), location, v.x, v.y, v.z);
}

/// As line_vertex.glsl has it.
struct PackedLine {
  glm::vec4 from;
  glm::vec4 to;
  glm::vec4 color;
};

}  // namespace

DepthRange depthRange(const PinholeCamera& camera, const Box& box) {
  float nearest = camera.view().zFar;
  float farthest = camera.view().zNear;
  for (const glm::vec3& corner : cornersOf(box)) {
    const float z = camera.cameraFromWorld(corner).z;
    nearest = std::min(nearest, z);
    farthest = std::max(farthest, z);
  }
  // A little more, so that rounding cuts nothing off.
  const float margin = 1e-3f * (farthest - nearest) + 1e-6f;
  DepthRange range{std::max(nearest - margin, camera.view().zNear), std::min(farthest + margin, camera.view().zFar)};
  if (!(range.farthest > range.nearest)) {  // nothing of it is in front of the eye
    range.farthest = range.nearest * 2;
  }
  return range;
}

void setView(const GladGLContext& gl, const GlObject& program, const PinholeCamera& camera, const DepthRange& range) {
  const View& view = camera.view();
  const glm::vec3 forward = glm::normalize(view.target - view.eye);
  const glm::vec3 right = glm::normalize(glm::cross(forward, view.up));
  setVector(gl, program, kEye, view.eye);
  setVector(gl, program, kRight, right);
  setVector(gl, program, kDown, glm::cross(forward, right));
  setVector(gl, program, kForward, forward);
  const glm::vec2 half = glm::vec2(camera.width(), camera.height()) / 2.0f;
  const glm::vec2 scale = camera.focalPixels() / half;
  const glm::vec2 center = camera.centerPixels() / half - 1.0f;
  gl.ProgramUniform2f(program.id(), kScale, scale.x, scale.y);
  gl.ProgramUniform2f(program.id(), kCenter, center.x, center.y);
  gl.ProgramUniform2f(program.id(), kRange, range.nearest, range.farthest);
}

MeshDraw::MeshDraw(GlContext& context)
    : context_(&context),
      program_(makeProgram(context, "mesh",
                           {{GL_VERTEX_SHADER, {shaders::kView, shaders::kMeshVertex}},
                            {GL_FRAGMENT_SHADER, {shaders::kEncode, shaders::kMeshFragment}}})) {}

void MeshDraw::draw(const GlMesh& mesh, const PinholeCamera& camera, const DepthRange& range) {
  const GladGLContext& gl = context_->gl();
  setView(gl, program_, camera, range);
  gl.UseProgram(program_.id());
  gl.BindVertexArray(mesh.vertexArray().id());
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * mesh.triangleCount()), GL_UNSIGNED_INT, nullptr);
  context_->check("drawing a mesh");
}

void MeshDraw::drawVertices(const GlMesh& mesh, const PinholeCamera& camera, const DepthRange& range, float pixels) {
  const GladGLContext& gl = context_->gl();
  setView(gl, program_, camera, range);
  gl.ProgramUniform1f(program_.id(), kPointPixels, pixels);
  gl.UseProgram(program_.id());
  gl.BindVertexArray(mesh.vertexArray().id());
  gl.Enable(GL_PROGRAM_POINT_SIZE);
  gl.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(mesh.vertexCount()));
  gl.Disable(GL_PROGRAM_POINT_SIZE);
  context_->check("drawing samples");
}

LineDraw::LineDraw(GlContext& context)
    : context_(&context),
      program_(makeProgram(context, "lines",
                           {{GL_VERTEX_SHADER, {shaders::kView, shaders::kLineVertex}},
                            {GL_FRAGMENT_SHADER, {shaders::kLineFragment}}})),
      vertexArray_(makeVertexArray(context)) {}

void LineDraw::draw(const std::vector<ColoredLine>& lines, const PinholeCamera& camera, const DepthRange& range,
                    float hidden) {
  if (lines.empty()) {
    return;
  }
  const GladGLContext& gl = context_->gl();
  std::vector<PackedLine> packed;
  packed.reserve(lines.size());
  for (const ColoredLine& line : lines) {
    packed.push_back({glm::vec4(line.from, line.widthPixels), glm::vec4(line.to, 0), line.color});
  }
  const GlObject buffer = makeBuffer(*context_, packed);
  setView(gl, program_, camera, range);
  gl.ProgramUniform2f(program_.id(), kPaneSize, static_cast<float>(camera.width()),
                      static_cast<float>(camera.height()));
  gl.UseProgram(program_.id());
  gl.BindVertexArray(vertexArray_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer.id());
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.DepthMask(GL_FALSE);
  const auto vertices = static_cast<GLsizei>(6 * lines.size());
  if (hidden > 0) {
    gl.ProgramUniform1f(program_.id(), kOpacity, hidden);
    gl.DepthFunc(GL_GREATER);
    gl.DrawArrays(GL_TRIANGLES, 0, vertices);
  }
  gl.ProgramUniform1f(program_.id(), kOpacity, 1);
  gl.DepthFunc(GL_LEQUAL);
  gl.DrawArrays(GL_TRIANGLES, 0, vertices);
  gl.DepthFunc(GL_LESS);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  context_->check("drawing lines");
}

}  // namespace ocelli
