#include <algorithm>
#include <array>
#include <cmath>

#include "oc_core/explore_window/draw_pane.h"
#include "oc_core/explore_window/explore_image_fit.h"
#include "oc_core/explore_window/explore_pane.h"
#include "oc_core/explore_window/pinhole_pane.h"
#include "oc_core/explore_window/plan_pane.h"
#include "oc_core/explore_window/view_pane.h"
#include "oc_core/window/image_texture.h"

namespace ocelli {

glm::ivec2 ExplorePaneFrame::pixels() const {
  const auto rounded = [this](float length) {
    return std::max(1, static_cast<int>(std::lround(length * pixelsPerUnit)));
  };
  return {rounded(rect.width), rounded(rect.height)};
}

void ExplorePaneFrame::copy(const ImageTexture& image, GlContext& context, const GlObject& framebuffer) const {
  const ExploreImageFit fit = exploreImageFit(rect, image.size());
  const glm::ivec2 corner(glm::round(fit.corner * pixelsPerUnit));
  const glm::ivec2 size(glm::round(glm::vec2(image.size()) * fit.scale * pixelsPerUnit));
  image.copyTo(context, framebuffer, corner, glm::max(size, glm::ivec2(1)));
}

void ExplorePane::ask(const ExplorePaneFrame&, WindowShape&) const {}

void ExplorePane::paint(const ExplorePaneFrame&, GlContext&, const GlObject&) {}

bool ExplorePane::handlePointer(const ExplorePaneFrame&, const InputEvent&, const glm::vec2&) {
  return false;
}

bool ExplorePane::handleKey(const ExplorePaneFrame&, const KeyEvent&) {
  return false;
}

std::span<const ExplorePaneKind> explorePanes() {
  static const std::array kinds{
      ExplorePaneKind{"view", "View", "", 0, true, false, true, makeViewPane},
      ExplorePaneKind{kPinholePane, "Pinhole", "Tab", 0.34f, false, false, false, makePinholePane},
      ExplorePaneKind{kPlanPane, "Plan", "M", 0.34f, true, false, false, makePlanPane},
      ExplorePaneKind{kDrawPane, "Draw a camera", "G", 0.5f, false, true, true, makeDrawPane},
  };
  return kinds;
}

}  // namespace ocelli
