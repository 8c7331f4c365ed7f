// What the colours of the viewer stand for. They are of the palette of Okabe and Ito, which people with any colour
// vision tell apart, and mean the same in every pane, legend and panel.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "oc_core/evaluation/error_image.h"
#include "oc_core/window/gui_style.h"

namespace ocelli {

inline constexpr GuiColor kReferenceColor = kOkabeItoSkyBlue;    ///< the reference view
inline constexpr GuiColor kRayColor = kOkabeItoSkyBlue;          ///< straight rays
inline constexpr GuiColor kBentRayColor = kOkabeItoOrange;       ///< rays that bend
inline constexpr GuiColor kPickedColor{255, 255, 255};           ///< the ray of the pixel under the pointer
inline constexpr GuiColor kCellColor = kOkabeItoYellow;          ///< the view cell
inline constexpr GuiColor kEyeColor = kOkabeItoReddishPurple;    ///< the user's eye
inline constexpr GuiColor kDisplayColor = kOkabeItoBluishGreen;  ///< the display itself: screen, rim
inline constexpr GuiColor kPaneColor{12, 13, 15};                ///< behind what a pane shows
/// The ends of the ramp of reference_fragment.glsl.
inline constexpr GuiColor kRampDark{0, 36, 92};
inline constexpr GuiColor kRampLight{252, 232, 84};
inline constexpr GuiColor kSpaceColor{0, 0, 0};  ///< behind a scene seen by an eye
/// As on the pages of `ocelli evaluate`.
inline constexpr GuiColor kMissingGui{kMissingColor.x, kMissingColor.y, kMissingColor.z};
inline constexpr GuiColor kMissingThickGui{kMissingThickColor.x, kMissingThickColor.y, kMissingThickColor.z};

/// sRGB values from 0 to 1.
inline glm::vec3 rgb(GuiColor color) {
  const auto [red, green, blue] = color.floats();
  return {red, green, blue};
}
inline glm::vec4 withOpacity(GuiColor color, float opacity) {
  return {rgb(color), opacity};
}
inline glm::vec4 opaque(GuiColor color) {
  return withOpacity(color, 1);
}

}  // namespace ocelli
