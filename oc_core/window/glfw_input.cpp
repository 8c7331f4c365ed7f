#include "oc_core/window/glfw_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <utility>

namespace ocelli {
namespace {

constexpr std::array<std::pair<int, Key>, 23> kOtherKeys{
    {{GLFW_KEY_LEFT, Key::kLeft},      {GLFW_KEY_RIGHT, Key::kRight},         {GLFW_KEY_UP, Key::kUp},
     {GLFW_KEY_DOWN, Key::kDown},      {GLFW_KEY_HOME, Key::kHome},           {GLFW_KEY_END, Key::kEnd},
     {GLFW_KEY_PAGE_UP, Key::kPageUp}, {GLFW_KEY_PAGE_DOWN, Key::kPageDown},  {GLFW_KEY_INSERT, Key::kInsert},
     {GLFW_KEY_DELETE, Key::kDelete},  {GLFW_KEY_ESCAPE, Key::kEscape},       {GLFW_KEY_TAB, Key::kTab},
     {GLFW_KEY_ENTER, Key::kEnter},    {GLFW_KEY_BACKSPACE, Key::kBackspace}, {GLFW_KEY_SPACE, Key::kSpace},
     {GLFW_KEY_MINUS, Key::kMinus},    {GLFW_KEY_EQUAL, Key::kEqual},         {GLFW_KEY_COMMA, Key::kComma},
     {GLFW_KEY_PERIOD, Key::kPeriod},  {GLFW_KEY_SLASH, Key::kSlash},         {GLFW_KEY_KP_ENTER, Key::kEnter},
     {GLFW_KEY_KP_ADD, Key::kEqual},   {GLFW_KEY_KP_SUBTRACT, Key::kMinus}}};

/// The key at the same place in a run of keys that both number one after the other.
std::optional<Key> inRun(int key, int first, int last, Key ours) {
  return key >= first && key <= last ? std::optional(static_cast<Key>(static_cast<int>(ours) + key - first))
                                     : std::nullopt;
}

}  // namespace

std::optional<Key> keyFromGlfw(int key) {
  for (const auto& found : {inRun(key, GLFW_KEY_A, GLFW_KEY_Z, Key::kA), inRun(key, GLFW_KEY_0, GLFW_KEY_9, Key::k0),
                            inRun(key, GLFW_KEY_F1, GLFW_KEY_F12, Key::kF1)}) {
    if (found) {
      return found;
    }
  }
  const auto* other = std::ranges::find(kOtherKeys, key, &std::pair<int, Key>::first);
  return other != kOtherKeys.end() ? std::optional(other->second) : std::nullopt;
}

std::optional<PointerButton> pointerButtonFromGlfw(int button) {
  switch (button) {
    case GLFW_MOUSE_BUTTON_LEFT:
      return PointerButton::kLeft;
    case GLFW_MOUSE_BUTTON_RIGHT:
      return PointerButton::kRight;
    case GLFW_MOUSE_BUTTON_MIDDLE:
      return PointerButton::kMiddle;
    default:  // not an enumeration of ours
      return std::nullopt;
  }
}

Modifiers modifiersFromGlfw(int modifiers) {
  return {(modifiers & GLFW_MOD_SHIFT) != 0, (modifiers & GLFW_MOD_CONTROL) != 0, (modifiers & GLFW_MOD_ALT) != 0};
}

}  // namespace ocelli
