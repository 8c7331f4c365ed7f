// Where things are in the window: a panel on the left, panes in two rows, that of a transfer function along the whole
// width below them, a bar at the bottom. Screen coordinates.
#pragma once

#include <vector>

#include "display_sim/viewer/viewer_state.h"

namespace ocelli {

struct WindowRect {
  float x = 0;
  float y = 0;
  float width = 0;
  float height = 0;

  float right() const { return x + width; }
  float bottom() const { return y + height; }
  bool contains(const glm::vec2& at) const { return at.x >= x && at.y >= y && at.x < right() && at.y < bottom(); }
};

struct PaneLayout {
  Pane pane = Pane::kScene;
  WindowRect header;
  WindowRect image;
};

struct ViewerLayout {
  WindowRect panel;  ///< without width where it is hidden
  WindowRect status;
  std::vector<PaneLayout> panes;  ///< those that show

  /// The pane whose image lies at this place; null where none does.
  const PaneLayout* paneAt(const glm::vec2& at) const;
  const PaneLayout* find(Pane pane) const;
};

/// `lengthScale`: screen coordinates for a length of 1 at 96 dots an inch.
ViewerLayout viewerLayout(const ViewerState& state, const glm::vec2& windowSize, float lengthScale);

}  // namespace ocelli
