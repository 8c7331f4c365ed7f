// Which bends of an image are large enough for a border and a number.
#pragma once

#include <glm/vec2.hpp>

#include "oc_core/explore_window/explore_window_model.h"

namespace ocelli {

struct TintExtent {
  glm::vec2 lower{0};
  glm::vec2 upper{0};
};

/// Of an outline that has points.
TintExtent extentOf(const WindowTint& tint);

/// Whether it bends, and is so large that a number fits into it. `scale` are lengths at 96 dots an inch for a pixel of
/// the image.
bool showsTint(const WindowTint& tint, float scale);

}  // namespace ocelli
