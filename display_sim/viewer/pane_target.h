// The image that a pane is drawn to: sRGB values and a depth, and where it is asked for the points in space that are
// seen. Row 0 is the top.
#pragma once

#include <glm/vec3.hpp>

#include "oc_core/gl/gl_object.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

class PaneTarget {
 public:
  enum class Holds { kColor, kColorAndPoints };

  explicit PaneTarget(GlContext& context, Holds holds = Holds::kColor) : context_(&context), holds_(holds) {}

  int width() const { return width_; }
  int height() const { return height_; }
  const GlObject& color() const { return color_; }
  const GlObject& points() const { return points_; }  ///< RGBA32F; w is 1 where something is seen
  const GlObject& framebuffer() const { return framebuffer_; }

  /// Binds it, in this size, cleared to `background` (sRGB) and to nothing seen. Depth test on, all else off. Hold a
  /// GlScope, here and below.
  void begin(int width, int height, const glm::vec3& background);
  Image<Rgb8> read() const;

 private:
  GlContext* context_;
  Holds holds_;
  int width_ = 0;
  int height_ = 0;
  GlObject color_;
  GlObject points_;
  GlObject depth_;
  GlObject framebuffer_;
};

}  // namespace ocelli
