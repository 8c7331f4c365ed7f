#include "oc_core/explore_window/explore_image_fit.h"

#include <algorithm>

namespace ocelli {

ExploreImageFit exploreImageFit(const ExplorePaneRect& rect, const glm::ivec2& size) {
  const glm::vec2 pixels(size);
  const float scale = std::min(rect.width / pixels.x, rect.height / pixels.y);
  const glm::vec2 shown = pixels * scale;
  return {glm::vec2(rect.x, rect.y) + (glm::vec2(rect.width, rect.height) - shown) * 0.5f, scale};
}

}  // namespace ocelli
