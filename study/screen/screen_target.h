// What a screen is drawn to before it is shown: sRGB values, row 0 at the top.
#pragma once

#include "oc_core/gl/gl_object.h"
#include "oc_core/image/png_file.h"
#include "study/screen/study_look.h"

namespace ocelli {

class ScreenTarget {
 public:
  /// Throws GlError. Hold a GlScope, here and below.
  ScreenTarget(GlContext& context, int width, int height);

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
  int width_;
  int height_;
  GlObject color_;
  GlObject framebuffer_;
};

}  // namespace ocelli
