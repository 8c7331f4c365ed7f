// OpenGL objects that delete themselves. Made by the functions below, which need OpenGL 4.5 (direct state access).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "oc_core/gl/gl_context.h"
#include "oc_core/image/image.h"

namespace ocelli {

enum class GlObjectKind { kBuffer, kTexture, kFramebuffer, kVertexArray, kProgram };

/// Owns one object of a context, which outlives it. Empty after a move.
class GlObject {
 public:
  GlObject() = default;
  GlObject(GlContext& context, GlObjectKind kind, uint32_t id) : context_(&context), kind_(kind), id_(id) {
    context.countObject(1);
  }
  GlObject(GlObject&& other) noexcept
      : context_(std::exchange(other.context_, nullptr)), kind_(other.kind_), id_(std::exchange(other.id_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(context_, other.context_);
    std::swap(kind_, other.kind_);
    std::swap(id_, other.id_);
    return *this;
  }
  ~GlObject();

  uint32_t id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  GlContext* context_ = nullptr;
  GlObjectKind kind_ = GlObjectKind::kBuffer;
  uint32_t id_ = 0;
};

/// A buffer of so many bytes, filled from `data` where it is not null. Throws GlError where the GPU has no room, or
/// where it exceeds what a shader may address. Hold a GlScope, here and below.
GlObject makeBuffer(GlContext& context, size_t bytes, const void* data = nullptr);

template <class Item>
GlObject makeBuffer(GlContext& context, std::span<const Item> items) {
  return makeBuffer(context, items.size_bytes(), items.data());
}
template <class Item>
GlObject makeBuffer(GlContext& context, const std::vector<Item>& items) {
  return makeBuffer(context, std::span<const Item>(items));
}

/// `internalFormat` is a sized one: GL_RGBA8, GL_R32F, ... Textures have one level, are looked up at the nearest texel,
/// and end at their borders.
GlObject makeTexture(GlContext& context, uint32_t internalFormat, int width, int height);
/// An array of layers.
GlObject makeTextureLayers(GlContext& context, uint32_t internalFormat, int width, int height, int layers);

/// Its colour attachments are the `colors`, in order; 0 for no `depth`. Throws GlError where the driver cannot draw to
/// them together.
GlObject makeFramebuffer(GlContext& context, std::span<const uint32_t> colors, uint32_t depth);

GlObject makeVertexArray(GlContext& context);

/// Reads one level of a texture, row 0 as the first. `format` and `type` as glGetTextureImage() takes them, for pixels
/// of type Pixel.
template <class Pixel>
Image<Pixel> readTexture(GlContext& context, const GlObject& texture, int width, int height, uint32_t format,
                         uint32_t type);
void readTextureBytes(GlContext& context, const GlObject& texture, uint32_t format, uint32_t type, size_t bytes,
                      void* to);
/// Reads `bytes` from the start of a buffer.
void readBuffer(GlContext& context, const GlObject& buffer, size_t bytes, void* to);

template <class Pixel>
Image<Pixel> readTexture(GlContext& context, const GlObject& texture, int width, int height, uint32_t format,
                         uint32_t type) {
  Image<Pixel> image(width, height);
  readTextureBytes(context, texture, format, type, image.size() * sizeof(Pixel), image.data());
  return image;
}

}  // namespace ocelli
