#include "oc_core/gl/gl_object.h"

#include "oc_core/base/check.h"
#include "oc_core/gl/gl_api.h"

namespace ocelli {
namespace {

void deleteObject(const GladGLContext& gl, GlObjectKind kind, uint32_t id) {
  switch (kind) {
    case GlObjectKind::kBuffer:
      gl.DeleteBuffers(1, &id);
      return;
    case GlObjectKind::kTexture:
      gl.DeleteTextures(1, &id);
      return;
    case GlObjectKind::kFramebuffer:
      gl.DeleteFramebuffers(1, &id);
      return;
    case GlObjectKind::kVertexArray:
      gl.DeleteVertexArrays(1, &id);
      return;
    case GlObjectKind::kProgram:
      gl.DeleteProgram(id);
      return;
  }
}

GlObject newTexture(GlContext& context, uint32_t target) {
  const GladGLContext& gl = context.gl();
  uint32_t id = 0;
  gl.CreateTextures(target, 1, &id);
  GlObject texture(context, GlObjectKind::kTexture, id);
  gl.TextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

void requireTextureSize(const GlContext& context, int width, int height) {
  const int most = context.info().maxTextureSize;
  if (width > most || height > most) {
    throw GlError("an image of " + std::to_string(width) + "x" + std::to_string(height) +
                      " pixels is larger than this GPU's " + std::to_string(most) + "x" + std::to_string(most),
                  nameOf(context.info().provider), "use a smaller image");
  }
}

}  // namespace

GlObject::~GlObject() {
  if (id_ == 0) {
    return;
  }
  context_->countObject(-1);
  try {
    const GlScope scope(*context_);
    deleteObject(context_->gl(), kind_, id_);
  } catch (const GlError&) {  // the context is lost, and its objects with it
  }
}

GlObject makeBuffer(GlContext& context, size_t bytes, const void* data) {
  if (bytes > static_cast<size_t>(context.info().maxStorageBytes)) {
    throw GlError("a buffer of " + std::to_string(bytes >> 20) + " MiB is larger than the " +
                      std::to_string(context.info().maxStorageBytes >> 20) + " MiB that this GPU's shaders can read",
                  nameOf(context.info().provider), "use a smaller scene or image");
  }
  const GladGLContext& gl = context.gl();
  uint32_t id = 0;
  gl.CreateBuffers(1, &id);
  GlObject buffer(context, GlObjectKind::kBuffer, id);
  // A buffer of no bytes is an error in OpenGL, but no scene has to think of that.
  gl.NamedBufferStorage(id, static_cast<GLsizeiptr>(bytes > 0 ? bytes : 4), bytes > 0 ? data : nullptr,
                        GL_DYNAMIC_STORAGE_BIT);
  context.check("making a buffer of " + std::to_string(bytes) + " bytes");
  return buffer;
}

GlObject makeTexture(GlContext& context, uint32_t internalFormat, int width, int height) {
  requireTextureSize(context, width, height);
  GlObject texture = newTexture(context, GL_TEXTURE_2D);
  context.gl().TextureStorage2D(texture.id(), 1, internalFormat, width, height);
  context.check("making an image of " + std::to_string(width) + "x" + std::to_string(height) + " pixels");
  return texture;
}

GlObject makeTextureLayers(GlContext& context, uint32_t internalFormat, int width, int height, int layers) {
  requireTextureSize(context, width, height);
  if (layers > context.info().maxTextureLayers) {
    throw GlError(
        std::to_string(layers) + " layers are more than this GPU's " + std::to_string(context.info().maxTextureLayers),
        nameOf(context.info().provider), "use a profile with fewer slices");
  }
  GlObject texture = newTexture(context, GL_TEXTURE_2D_ARRAY);
  context.gl().TextureStorage3D(texture.id(), 1, internalFormat, width, height, layers);
  context.check("making " + std::to_string(layers) + " images of " + std::to_string(width) + "x" +
                std::to_string(height) + " pixels");
  return texture;
}

GlObject makeFramebuffer(GlContext& context, std::span<const uint32_t> colors, uint32_t depth) {
  const GladGLContext& gl = context.gl();
  uint32_t id = 0;
  gl.CreateFramebuffers(1, &id);
  GlObject framebuffer(context, GlObjectKind::kFramebuffer, id);
  std::vector<GLenum> targets;
  for (const uint32_t color : colors) {
    targets.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(targets.size()));
    gl.NamedFramebufferTexture(id, targets.back(), color, 0);
  }
  if (depth != 0) {
    gl.NamedFramebufferTexture(id, GL_DEPTH_ATTACHMENT, depth, 0);
  }
  gl.NamedFramebufferDrawBuffers(id, static_cast<GLsizei>(targets.size()), targets.data());
  if (gl.CheckNamedFramebufferStatus(id, GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw GlError("this driver cannot draw to the images that are needed", nameOf(context.info().provider),
                  "update the graphics driver");
  }
  context.check("making a framebuffer");
  return framebuffer;
}

GlObject makeVertexArray(GlContext& context) {
  uint32_t id = 0;
  context.gl().CreateVertexArrays(1, &id);
  return {context, GlObjectKind::kVertexArray, id};
}

void readTextureBytes(GlContext& context, const GlObject& texture, uint32_t format, uint32_t type, size_t bytes,
                      void* to) {
  const GladGLContext& gl = context.gl();
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.GetTextureImage(texture.id(), 0, format, type, static_cast<GLsizei>(bytes), to);
  context.check("reading an image back");
}

void readBuffer(GlContext& context, const GlObject& buffer, size_t bytes, void* to) {
  const GladGLContext& gl = context.gl();
  gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl.GetNamedBufferSubData(buffer.id(), 0, static_cast<GLsizeiptr>(bytes), to);
  context.check("reading a buffer back");
}

}  // namespace ocelli
