#include "display_sim/viewer/viewer_layout.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ocelli {
namespace {

constexpr float kPanelWidth = 316;
constexpr float kMaxPanelShare = 0.45f;
constexpr float kStatusHeight = 28;
constexpr float kHeaderHeight = 28;
constexpr float kGap = 2;
constexpr float kTransferShare = 0.34f;  // of the height

PaneLayout paneIn(Pane pane, const WindowRect& rect, float headerHeight) {
  const float header = std::min(headerHeight, rect.height);
  return {pane,
          {rect.x, rect.y, rect.width, header},
          {rect.x, rect.y + header, rect.width, std::max(rect.height - header, 1.0f)}};
}

/// In two rows; two panes are beside each other.
void addRows(std::vector<PaneLayout>& panes, const std::vector<Pane>& shown, const WindowRect& area, float gap,
             float header) {
  const size_t inUpperRow = shown.size() == 2 ? 2 : shown.size() / 2;
  const float height = shown.size() == 2 ? area.height : std::floor((area.height - gap) / 2);
  for (size_t i = 0; i < shown.size(); ++i) {
    const bool isLow = i >= inUpperRow;
    const auto columns = static_cast<float>(isLow ? shown.size() - inUpperRow : inUpperRow);
    const auto column = static_cast<float>(isLow ? i - inUpperRow : i);
    const float width = std::floor((area.width - gap * (columns - 1)) / columns);
    panes.push_back(paneIn(
        shown[i], {area.x + column * (width + gap), area.y + (isLow ? height + gap : 0), width, height}, header));
  }
}

}  // namespace

const PaneLayout* ViewerLayout::paneAt(const glm::vec2& at) const {
  const auto found =
      std::find_if(panes.begin(), panes.end(), [&](const PaneLayout& p) { return p.image.contains(at); });
  return found == panes.end() ? nullptr : &*found;
}

const PaneLayout* ViewerLayout::find(Pane pane) const {
  const auto found = std::find_if(panes.begin(), panes.end(), [&](const PaneLayout& p) { return p.pane == pane; });
  return found == panes.end() ? nullptr : &*found;
}

ViewerLayout viewerLayout(const ViewerState& state, const glm::vec2& windowSize, float lengthScale) {
  const glm::vec2 size(std::max(windowSize.x, 4.0f), std::max(windowSize.y, 4.0f));
  ViewerLayout layout;
  const float statusHeight = std::min(std::round(kStatusHeight * lengthScale), size.y / 2);
  layout.status = {0, size.y - statusHeight, size.x, statusHeight};
  const float panelWidth = std::round(std::min(kPanelWidth * lengthScale, kMaxPanelShare * size.x));
  layout.panel = {0, 0, state.panel ? panelWidth : 0, size.y - statusHeight};

  const float gap = std::round(kGap * lengthScale);
  const float header = std::round(kHeaderHeight * lengthScale);
  const float left = layout.panel.width > 0 ? layout.panel.width + gap : 0;
  const WindowRect area{left, 0, size.x - left, size.y - statusHeight - gap};
  std::vector<Pane> shown;
  std::copy_if(kPanes.begin(), kPanes.end(), std::back_inserter(shown), [&](Pane pane) {
    return pane != Pane::kTransfer && (state.maximised ? pane == *state.maximised : isOffered(state, pane));
  });
  std::ranges::stable_partition(shown, [](Pane pane) { return pane == Pane::kVolume; });  // first, where there is one
  // The transfer function belongs to what it acts on: below it, along the whole width.
  const bool hasStrip =
      isOffered(state, Pane::kTransfer) && (!state.maximised || *state.maximised == Pane::kVolume) && !shown.empty();
  const float stripHeight = hasStrip ? std::floor(kTransferShare * area.height) : 0;
  const WindowRect grid{area.x, area.y, area.width, area.height - stripHeight - (hasStrip ? gap : 0)};
  if (shown.size() <= 1) {
    layout.panes.push_back(paneIn(shown.empty() ? Pane::kTransfer : shown.front(), grid, header));
  } else {
    addRows(layout.panes, shown, grid, gap, header);
  }
  if (hasStrip) {
    layout.panes.push_back(
        paneIn(Pane::kTransfer, {area.x, area.bottom() - stripHeight, area.width, stripHeight}, header));
  }
  return layout;
}

}  // namespace ocelli
