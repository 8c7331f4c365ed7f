// A gamepad as motion and as presses of the table of keys.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "oc_core/base/gamepad_state.h"
#include "oc_core/explore_window/explore_keys.h"

namespace ocelli {

class ExploreGamepad {
 public:
  struct Reading {
    WindowMotion motion;
    std::vector<const ExploreKeyAction*> pressed;  ///< since the reading before
    bool isUsed = false;                           ///< something is held or has been pressed
  };

  /// Nothing: there is none, or the window has lost the keyboard; what was held counts as released.
  Reading read(const std::optional<GamepadState>& state);

 private:
  std::array<bool, std::tuple_size_v<decltype(GamepadState::buttons)>> before_{};
};

}  // namespace ocelli
