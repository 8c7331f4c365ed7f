// What the pointer does in the pane of the transfer function: drags points, adds one by a double click, moves and zooms
// the values that show.
#pragma once

#include <optional>

#include "display_sim/viewer/viewer_keys.h"
#include "display_sim/viewer/viewer_layout.h"
#include "display_sim/viewer/viewer_state.h"

namespace ocelli {

/// How near to a point the pointer takes hold of it, and how far apart the clicks of a double click are at most; screen
/// coordinates at 96 dots an inch.
inline constexpr double kPointReach = 9;
inline constexpr double kDoubleClickReach = 5;
inline constexpr double kDoubleClickSeconds = 0.4;

inline constexpr const char* kTooManyPoints = "there are as many points as a file may have";

/// Where the function is plotted in the window: its values to the right along the axis, opacity upwards.
struct TransferFrame {
  glm::dvec2 corner{0};  ///< the least value at an opacity of 1
  glm::dvec2 size{1};
  ValueAxis axis;
  double lengthScale = 1;  ///< as of viewerLayout()

  glm::dvec2 placeOf(double value, double opacity) const {
    return corner + glm::dvec2(axis.shareOf(value), 1 - opacity) * size;
  }
  double valueAt(const glm::dvec2& at) const { return axis.valueAt((at.x - corner.x) / size.x); }
  double opacityAt(const glm::dvec2& at) const { return 1 - (at.y - corner.y) / size.y; }
};

/// Of a pane that covers `image`.
TransferFrame transferFrame(const ViewerState& state, const WindowRect& image, float lengthScale);

class TransferPointer {
 public:
  /// `at` is a place of the window. Chooses a point there and takes hold of it; the second click of a double click
  /// beside all of them adds one. Returns what the user should know; empty: nothing.
  const char* press(ViewerState& state, const TransferFrame& frame, const glm::dvec2& at);
  /// Drags what it has hold of: a point, or else the values that show.
  void move(ViewerState& state, const TransferFrame& frame, const glm::dvec2& at);
  void release(ViewerState& state);
  /// Less or more of the values, around the pointer.
  static void scroll(ViewerState& state, const TransferFrame& frame, const glm::dvec2& at, double up);
  bool isHeld() const { return held_.has_value(); }

 private:
  struct Held {
    std::optional<size_t> point;  ///< nothing: the values
    glm::dvec2 from{0};           ///< where the pointer was last; of a point: its distance from the pointer
  };
  struct Click {
    glm::dvec2 at{0};
    double seconds = 0;
  };
  std::optional<Held> held_;
  std::optional<Click> click_;
};

/// For the help.
const std::vector<PointerBinding>& transferPointerBindings();

}  // namespace ocelli
