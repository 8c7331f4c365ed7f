#include "oc_core/explore_window/explore_layout.h"

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

constexpr float kChoicesHeight = 40;
constexpr float kStatusHeight = 30;
constexpr float kTitleHeight = 26;
constexpr float kPaneGap = 2;
constexpr float kMinColumnWidth = 240;

ExplorePaneRect atLeastOne(ExplorePaneRect rect) {
  rect.width = std::max(rect.width, 1.0f);
  rect.height = std::max(rect.height, 1.0f);
  return rect;
}

}  // namespace

const ExploreWindowLayout::Pane* ExploreWindowLayout::paneAt(const glm::vec2& at) const {
  const auto found = std::ranges::find_if(panes, [&](const Pane& pane) { return pane.rect.contains(at); });
  return found == panes.end() ? nullptr : &*found;
}

ExploreWindowLayout exploreWindowLayout(const std::vector<size_t>& kinds, float columnShare,
                                        const glm::vec2& windowSize, float lengthScale) {
  const glm::vec2 size(std::max(windowSize.x, 4.0f), std::max(windowSize.y, 4.0f));
  const float above = std::min(std::round(kChoicesHeight * lengthScale), std::floor(size.y / 4));
  const float below = std::min(std::round(kStatusHeight * lengthScale), std::floor(size.y / 4));
  const float gap = std::round(kPaneGap * lengthScale);
  const float title = std::round(kTitleHeight * lengthScale);
  ExploreWindowLayout layout;
  layout.choices = {0, 0, size.x, above};
  layout.status = {0, size.y - below, size.x, below};
  const size_t beside = kinds.empty() ? 0 : kinds.size() - 1;
  const float wanted = std::max(std::round(columnShare * size.x), kMinColumnWidth * lengthScale);
  const float column = beside == 0 ? 0 : std::min(wanted, std::floor(size.x / 2));
  const float height = size.y - above - below;
  if (!kinds.empty()) {
    layout.panes.push_back(
        {kinds.front(), atLeastOne({0, above, size.x - column - (beside == 0 ? 0 : gap), height}), {0, above, 0, 0}});
  }
  const float each =
      beside == 0 ? 0 : std::floor((height - gap * static_cast<float>(beside - 1)) / static_cast<float>(beside));
  for (size_t i = 0; i < beside; ++i) {
    const float top = above + static_cast<float>(i) * (each + gap);
    const ExplorePaneRect head{size.x - column, top, column, std::min(title, std::floor(each / 2))};
    layout.panes.push_back(
        {kinds[i + 1], atLeastOne({head.x, head.bottom(), column, each - head.height}), atLeastOne(head)});
  }
  return layout;
}

}  // namespace ocelli
