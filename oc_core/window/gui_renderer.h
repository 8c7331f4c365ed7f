// Draws what Dear ImGui makes.
#pragma once

#include <cstddef>
#include <cstdint>

#include "oc_core/gl/gl_object.h"

struct ImDrawData;

namespace ocelli {

class GuiRenderer {
 public:
  /// Hold a GlScope, here and below.
  explicit GuiRenderer(GlContext& context);

  /// A texture of white with this opacity, row by row.
  GlObject makeFontTexture(int width, int height, const uint8_t* opacity);

  /// Into the bound framebuffer, from its row 0 on. Colours and textures hold sRGB values, which are blended and
  /// written as they are, also where the framebuffer could convert them. Afterwards nothing is blended, clipped or
  /// culled.
  void draw(const ImDrawData& data);

 private:
  /// A buffer that grows.
  struct Room {
    GlObject buffer;
    size_t bytes = 0;
  };
  void upload(const ImDrawData& data);
  /// Whether it is another buffer now.
  bool reserve(Room& room, size_t bytes);

  GlContext* context_;
  GlObject program_;
  GlObject vertexArray_;
  Room vertices_;
  Room indices_;
};

}  // namespace ocelli
