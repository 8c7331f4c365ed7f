// What the pointer does in the lens pane: takes hold of a lens, or clicks beside all of them to add one.
#pragma once

#include <optional>

#include "display_sim/viewer/viewer_state.h"
#include "oc_core/camera/gpc_lens_hit.h"

namespace ocelli {

/// How near to a corner or an edge the pointer takes hold of it, and how far it may move in a click; screen coordinates
/// at 96 dots an inch.
inline constexpr double kLensReach = 7;
inline constexpr double kClickReach = 4;

class LensPointer {
 public:
  /// Of the picture in the window: where its share (0, 0) lies, and how large it is.
  struct Frame {
    glm::dvec2 corner{0};
    glm::dvec2 size{1};
    double lengthScale = 1;  ///< as of viewerLayout()

    glm::dvec2 shareAt(const glm::dvec2& at) const { return (at - corner) / size; }
  };

  /// `at` is a place of the window. Returns whether the pointer has hold of a lens, which is then the chosen one; where
  /// it is locked, nothing moves. Otherwise it may become a click.
  bool press(ViewerState& state, const Frame& frame, const glm::dvec2& at);
  /// Returns whether nothing else should follow the pointer: it drags a lens, or is still within a click.
  bool move(ViewerState& state, const Frame& frame, const glm::dvec2& at);
  /// Returns why a click added no lens; empty where it did, or was none.
  const char* release(ViewerState& state, const Frame& frame);
  /// Zooms the lens under the pointer; false where there is none.
  static bool scroll(ViewerState& state, const Frame& frame, const glm::dvec2& at, double up);
  /// The pane has gone.
  void cancel() { *this = {}; }
  bool isDragging() const { return drag_.has_value(); }

 private:
  std::optional<LensDrag> drag_;
  GpcLayout dragged_;  ///< what the drag made last: where something else did, it ends
  bool holdsLocked_ = false;
  std::optional<glm::dvec2> click_;  ///< where it began
};

}  // namespace ocelli
