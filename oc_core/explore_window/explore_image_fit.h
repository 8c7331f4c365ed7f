// Where an image stands in a pane: as large as it can be, in the middle, in its own shape.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "oc_core/explore_window/explore_layout.h"

namespace ocelli {

struct ExploreImageFit {
  glm::vec2 corner{0};  ///< screen coordinates of the window
  float scale = 1;      ///< screen coordinates for a pixel of the image

  glm::vec2 onScreen(const glm::vec2& pixel) const { return corner + pixel * scale; }
  glm::vec2 inImage(const glm::vec2& point) const { return (point - corner) / scale; }
};

/// `size` of the image, pixels, at least 1.
ExploreImageFit exploreImageFit(const ExplorePaneRect& rect, const glm::ivec2& size);

}  // namespace ocelli
