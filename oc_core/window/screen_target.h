// What a screen or a window is drawn to before it is shown: sRGB values, row 0 at the top. Sizes are pixels.
#pragma once

#include "oc_core/gl/gl_object.h"
#include "oc_core/image/png_file.h"
#include "oc_core/window/gui_style.h"

namespace ocelli {

class ScreenTarget {
 public:
  /// Without a size, until resize().
  explicit ScreenTarget(GlContext& context) : context_(&context) {}
  /// Throws GlError. Hold a GlScope, here and below.
  ScreenTarget(GlContext& context, int width, int height) : ScreenTarget(context) { resize(width, height); }

  /// What was drawn is lost where the size is another one. Throws GlError.
  void resize(int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }
  const GlObject& color() const { return color_; }
  const GlObject& framebuffer() const { return framebuffer_; }

  void clear(GuiColor color);
  /// For what draws to the bound framebuffer.
  void bind();
  Image<Rgb8> read() const;

 private:
  GlContext* context_;
  int width_ = 0;
  int height_ = 0;
  GlObject color_;
  GlObject framebuffer_;
};

}  // namespace ocelli
