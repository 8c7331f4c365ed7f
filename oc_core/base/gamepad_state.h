// What a gamepad shows at a moment, as GLFW names its parts.
#pragma once

#include <array>
#include <string>

namespace ocelli {

struct GamepadState {
  std::string name;  ///< "Xbox Wireless Controller"
  /// South, east, west, north (A, B, X, Y of an Xbox controller), left and right bumper, back, start, guide, left and
  /// right stick pressed, and the directional pad's up, right, down, left.
  std::array<bool, 15> buttons{};
  /// Left stick to the right and down, right stick to the right and down, left and right trigger: -1 to 1; triggers
  /// rest at -1.
  std::array<float, 6> axes{0, 0, 0, 0, -1, -1};
};

}  // namespace ocelli
