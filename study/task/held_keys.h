// Which keys are down, and whether Shift was when they went down: that tells arrows that move the pointer from arrows
// that walk.
#pragma once

#include <array>
#include <cstdint>

#include "oc_core/base/input_event.h"

namespace ocelli {

class HeldKeys {
 public:
  void handle(const KeyEvent& event) {
    state_[static_cast<size_t>(event.key)] = !event.pressed ? kUp : event.modifiers.shift ? kShifted : kPlain;
  }
  bool plain(Key key) const { return state_[static_cast<size_t>(key)] == kPlain; }
  bool shifted(Key key) const { return state_[static_cast<size_t>(key)] == kShifted; }
  /// With Shift or without.
  bool any(Key key) const { return state_[static_cast<size_t>(key)] != kUp; }

 private:
  enum State : uint8_t { kUp, kPlain, kShifted };
  std::array<State, kKeyCount> state_{};
};

}  // namespace ocelli
