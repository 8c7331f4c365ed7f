// Gamepads, as GLFW finds them.
#pragma once

#include <optional>

#include "oc_core/base/gamepad_state.h"

namespace ocelli {

/// The first gamepad that is connected, and whose buttons the system knows by name; nothing where there is none. On the
/// main thread, with a window or after initializeGlfw().
std::optional<GamepadState> readFirstGamepad();

}  // namespace ocelli
