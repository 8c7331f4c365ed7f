#include "oc_core/explore_window/explore_gamepad.h"

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

/// Sticks rest within this, as they tremble.
constexpr float kStickRest = 0.18f;
constexpr size_t kLeftStickPressed = 9;

float beyondRest(float axis) {
  const float beyond = std::max(std::abs(axis) - kStickRest, 0.0f) / (1 - kStickRest);
  return std::copysign(std::min(beyond, 1.0f), axis) * (beyond > 0 ? 1.0f : 0.0f);
}

}  // namespace

ExploreGamepad::Reading ExploreGamepad::read(const std::optional<GamepadState>& state) {
  Reading reading;
  if (!state) {
    before_ = {};
    return reading;
  }
  const auto& axes = state->axes;
  reading.motion.right = beyondRest(axes[0]);
  reading.motion.ahead = beyondRest(-axes[1]);
  reading.motion.turnRight = beyondRest(axes[2]);
  reading.motion.lookUp = beyondRest(-axes[3]);
  reading.isUsed = !(reading.motion == WindowMotion{});
  reading.motion.fast = state->buttons[kLeftStickPressed];
  for (size_t i = 0; i < before_.size(); ++i) {
    const bool isNew = state->buttons[i] && !before_[i];
    if (const ExploreKeyAction* action = isNew ? exploreActionOfPadButton(static_cast<int>(i)) : nullptr) {
      reading.pressed.push_back(action);
      reading.isUsed = true;
    }
    before_[i] = state->buttons[i];
  }
  return reading;
}

}  // namespace ocelli
