#include "oc_core/window/gamepads.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <iterator>

namespace ocelli {

std::optional<GamepadState> readFirstGamepad() {
  for (int number = GLFW_JOYSTICK_1; number <= GLFW_JOYSTICK_LAST; ++number) {
    GLFWgamepadstate state{};
    if (glfwJoystickIsGamepad(number) != GLFW_TRUE || glfwGetGamepadState(number, &state) != GLFW_TRUE) {
      continue;
    }
    GamepadState found;
    static_assert(std::size(decltype(state.buttons){}) == std::tuple_size_v<decltype(found.buttons)>);
    static_assert(std::size(decltype(state.axes){}) == std::tuple_size_v<decltype(found.axes)>);
    const char* const name = glfwGetGamepadName(number);
    found.name = name != nullptr ? name : "gamepad";
    std::ranges::transform(state.buttons, found.buttons.begin(), [](unsigned char b) { return b == GLFW_PRESS; });
    std::ranges::copy(state.axes, found.axes.begin());
    return found;
  }
  return std::nullopt;
}

}  // namespace ocelli
