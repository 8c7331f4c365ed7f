// Keys, buttons and modifiers as GLFW numbers them, as ours.
#pragma once

#include <optional>

#include "oc_core/base/input_event.h"

namespace ocelli {

/// By place on the keyboard; the keypad's Enter, plus and minus are those of the main block. Nothing for other keys.
std::optional<Key> keyFromGlfw(int key);
/// Nothing for a fourth button and more.
std::optional<PointerButton> pointerButtonFromGlfw(int button);
Modifiers modifiersFromGlfw(int modifiers);

}  // namespace ocelli
