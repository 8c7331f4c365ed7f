// Foci to try ways with.
#pragma once

#include "oc_core/focus/focus_way.h"

namespace ocelli::test {

inline constexpr glm::ivec2 kFocusSize{320, 240};

/// One of 80 x 80 pixels around (120, 120), 4x, whose transition is as wide as its half: all borders lie between
/// pixels.
inline GpcLayout squareFocus(const char* sampling = "cubic") {
  return {findGpcSampling(sampling), {{{0.375f, 0.5f}, {0.25f, 80 / 240.0f}, 4, 1}}};
}
inline GpcLayout twoFoci() {
  return {findGpcSampling("cubic"),
          {{{0.27f, 0.42f}, {0.22f, 0.3f}, 3, 0.8f}, {{0.77f, 0.62f}, {0.14f, 0.2f}, 6, 1.2f}}};
}

inline const FocusWay& focusWay(const std::string& name) {
  const auto ways = focusWays();
  return *std::find_if(ways.begin(), ways.end(), [&](const FocusWay& each) { return each.name == name; });
}

}  // namespace ocelli::test
