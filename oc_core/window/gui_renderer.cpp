#include "oc_core/window/gui_renderer.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "oc_core/base/check.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/window/shaders.h"

namespace ocelli {
namespace {

constexpr GLint kWindowOrigin = 0;  // locations of the vertex shader
constexpr GLint kWindowSize = 1;
constexpr GLenum kIndexType = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;

void describe(const GladGLContext& gl, GLuint array, GLuint location, GLint count, GLenum type, bool normalized,
              size_t offset) {
  gl.VertexArrayAttribFormat(array, location, count, type, static_cast<GLboolean>(normalized),
                             static_cast<GLuint>(offset));
  gl.VertexArrayAttribBinding(array, location, 0);
  gl.EnableVertexArrayAttrib(array, location);
}

/// Everything off that others may have left on.
void setPlainState(const GladGLContext& gl) {
  for (const GLenum off : {GL_DEPTH_TEST, GL_CULL_FACE, GL_STENCIL_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_CLIP_DISTANCE0,
                           GL_FRAMEBUFFER_SRGB}) {
    gl.Disable(off);
  }
  gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

/// Clips to a rectangle of the window; false where nothing of it is in the framebuffer.
bool clip(const GladGLContext& gl, const ImDrawData& data, const ImVec4& rectangle, int width, int height) {
  const auto pixel = [](float position, float origin, float scale, int most) {
    return std::clamp(static_cast<int>(std::lround((position - origin) * scale)), 0, most);
  };
  const int left = pixel(rectangle.x, data.DisplayPos.x, data.FramebufferScale.x, width);
  const int top = pixel(rectangle.y, data.DisplayPos.y, data.FramebufferScale.y, height);
  const int right = pixel(rectangle.z, data.DisplayPos.x, data.FramebufferScale.x, width);
  const int bottom = pixel(rectangle.w, data.DisplayPos.y, data.FramebufferScale.y, height);
  if (right <= left || bottom <= top) {
    return false;
  }
  gl.Scissor(left, top, right - left, bottom - top);
  return true;
}

}  // namespace

GuiRenderer::GuiRenderer(GlContext& context)
    : context_(&context),
      program_(makeProgram(context, "gui",
                           {{GL_VERTEX_SHADER, {shaders::kGuiVert}}, {GL_FRAGMENT_SHADER, {shaders::kGuiFrag}}})),
      vertexArray_(makeVertexArray(context)) {
  const GladGLContext& gl = context.gl();
  describe(gl, vertexArray_.id(), 0, 2, GL_FLOAT, false, offsetof(ImDrawVert, pos));
  describe(gl, vertexArray_.id(), 1, 2, GL_FLOAT, false, offsetof(ImDrawVert, uv));
  describe(gl, vertexArray_.id(), 2, 4, GL_UNSIGNED_BYTE, true, offsetof(ImDrawVert, col));
}

GlObject GuiRenderer::makeFontTexture(int width, int height, const uint8_t* opacity) {
  const GladGLContext& gl = context_->gl();
  GlObject texture = makeTexture(*context_, GL_R8, width, height);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TextureSubImage2D(texture.id(), 0, 0, 0, width, height, GL_RED, GL_UNSIGNED_BYTE, opacity);
  const std::array<GLint, 4> whiteOfOpacity{GL_ONE, GL_ONE, GL_ONE, GL_RED};
  gl.TextureParameteriv(texture.id(), GL_TEXTURE_SWIZZLE_RGBA, whiteOfOpacity.data());
  gl.TextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  context_->check("uploading the font");
  return texture;
}

bool GuiRenderer::reserve(Room& room, size_t bytes) {
  if (bytes <= room.bytes) {
    return false;
  }
  room.bytes = bytes + bytes / 2;
  room.buffer = GlObject();  // the old one goes first
  room.buffer = makeBuffer(*context_, room.bytes);
  return true;
}

void GuiRenderer::upload(const ImDrawData& data) {
  const GladGLContext& gl = context_->gl();
  if (reserve(vertices_, static_cast<size_t>(data.TotalVtxCount) * sizeof(ImDrawVert))) {
    gl.VertexArrayVertexBuffer(vertexArray_.id(), 0, vertices_.buffer.id(), 0, sizeof(ImDrawVert));
  }
  if (reserve(indices_, static_cast<size_t>(data.TotalIdxCount) * sizeof(ImDrawIdx))) {
    gl.VertexArrayElementBuffer(vertexArray_.id(), indices_.buffer.id());
  }
  GLintptr vertexByte = 0;
  GLintptr indexByte = 0;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    const GLsizeiptr vertexBytes = list.VtxBuffer.size_in_bytes();
    const GLsizeiptr indexBytes = list.IdxBuffer.size_in_bytes();
    gl.NamedBufferSubData(vertices_.buffer.id(), vertexByte, vertexBytes, list.VtxBuffer.Data);
    gl.NamedBufferSubData(indices_.buffer.id(), indexByte, indexBytes, list.IdxBuffer.Data);
    vertexByte += vertexBytes;
    indexByte += indexBytes;
  }
}

void GuiRenderer::draw(const ImDrawData& data) {
  const GladGLContext& gl = context_->gl();
  GLint framebuffer = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  OC_CHECK(framebuffer != 0, "bind a framebuffer object to draw panels to");
  const int width = static_cast<int>(std::lround(data.DisplaySize.x * data.FramebufferScale.x));
  const int height = static_cast<int>(std::lround(data.DisplaySize.y * data.FramebufferScale.y));
  if (width <= 0 || height <= 0 || data.TotalIdxCount == 0) {
    return;
  }
  upload(data);
  setPlainState(gl);
  gl.Enable(GL_BLEND);
  gl.Enable(GL_SCISSOR_TEST);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.Viewport(0, 0, width, height);
  gl.UseProgram(program_.id());
  gl.ProgramUniform2f(program_.id(), kWindowOrigin, data.DisplayPos.x, data.DisplayPos.y);
  gl.ProgramUniform2f(program_.id(), kWindowSize, data.DisplaySize.x, data.DisplaySize.y);
  gl.BindSampler(0, 0);
  gl.BindVertexArray(vertexArray_.id());

  size_t firstVertex = 0;
  size_t firstIndex = 0;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      OC_CHECK(command.UserCallback == nullptr, "panels draw by themselves: show a texture instead of a callback");
      if (!clip(gl, data, command.ClipRect, width, height)) {
        continue;
      }
      gl.BindTextureUnit(0, static_cast<GLuint>(reinterpret_cast<uintptr_t>(command.GetTexID())));
      gl.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), kIndexType,
                                std::bit_cast<const void*>((firstIndex + command.IdxOffset) * sizeof(ImDrawIdx)),
                                static_cast<GLint>(firstVertex + command.VtxOffset));
    }
    firstVertex += static_cast<size_t>(list.VtxBuffer.Size);
    firstIndex += static_cast<size_t>(list.IdxBuffer.Size);
  }
  setPlainState(gl);
  context_->check("drawing the panels");
}

}  // namespace ocelli
