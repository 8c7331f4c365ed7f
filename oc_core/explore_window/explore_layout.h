// Where things stand in the window: the choices above, the view below them, a column of small panes beside it, and a
// line of states at the bottom. Screen coordinates.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace ocelli {

struct ExplorePaneRect {
  float x = 0;
  float y = 0;
  float width = 1;
  float height = 1;

  float right() const { return x + width; }
  float bottom() const { return y + height; }
  bool contains(const glm::vec2& p) const { return p.x >= x && p.x < right() && p.y >= y && p.y < bottom(); }
  bool operator==(const ExplorePaneRect&) const = default;
};

struct ExploreWindowLayout {
  struct Pane {
    size_t kind = 0;        ///< of explorePanes()
    ExplorePaneRect rect;   ///< without its title
    ExplorePaneRect title;  ///< empty (no height) over the large one
  };
  ExplorePaneRect choices;
  ExplorePaneRect status;
  std::vector<Pane> panes;  ///< the large one first

  /// Nothing (null) beside panes.
  const Pane* paneAt(const glm::vec2& at) const;
};

/// `kinds` are the panes that show, the large one first; the column takes that share of the width. `lengthScale` as of
/// GuiLayer. Every rectangle is at least one
/// unit wide and tall, however small the window is.
ExploreWindowLayout exploreWindowLayout(const std::vector<size_t>& kinds, float columnShare,
                                        const glm::vec2& windowSize, float lengthScale);

}  // namespace ocelli
