// What a person does to a window: from GLFW where there is one, from a script where there is none, so that whatever
// takes them behaves alike. Positions and sizes are in screen coordinates, origin at the top left.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ocelli {

/// Keys by their place on a US keyboard.
enum class Key {
  // clang-format off
  kA, kB, kC, kD, kE, kF, kG, kH, kI, kJ, kK, kL, kM, kN, kO, kP, kQ, kR, kS, kT, kU, kV, kW, kX, kY, kZ,
  k0, k1, k2, k3, k4, k5, k6, k7, k8, k9,
  kF1, kF2, kF3, kF4, kF5, kF6, kF7, kF8, kF9, kF10, kF11, kF12,
  kLeft, kRight, kUp, kDown, kHome, kEnd, kPageUp, kPageDown, kInsert, kDelete,
  kEscape, kTab, kEnter, kBackspace, kSpace, kMinus, kEqual, kComma, kPeriod, kSlash,
  // clang-format on
};
inline constexpr size_t kKeyCount = static_cast<size_t>(Key::kSlash) + 1;

/// Keys that are held while something else happens.
struct Modifiers {
  bool shift = false;
  bool control = false;
  bool alt = false;
};

enum class PointerButton { kLeft, kRight, kMiddle };

struct KeyEvent {
  Key key = Key::kSpace;
  bool pressed = true;  ///< repeats count as pressed
  Modifiers modifiers;
};
struct TextEvent {
  char32_t character = 0;
};
struct PointerMoveEvent {
  double x = 0;
  double y = 0;
};
struct PointerButtonEvent {
  PointerButton button = PointerButton::kLeft;
  bool pressed = true;
  Modifiers modifiers;
};
struct ScrollEvent {
  double right = 0;
  double up = 0;  ///< 1 for a step of a wheel away from the person
};
/// The window has another size, or moved to a screen of another density.
struct ResizeEvent {
  int width = 0;
  int height = 0;
  double pixelsPerUnit = 1;  ///< framebuffer pixels for each screen coordinate
  double contentScale = 1;   ///< how much larger than at 96 dots an inch things should be drawn
};
struct DropEvent {
  std::vector<std::string> files;
};
struct CloseEvent {};

using InputEvent = std::variant<KeyEvent, TextEvent, PointerMoveEvent, PointerButtonEvent, ScrollEvent, ResizeEvent,
                                DropEvent, CloseEvent>;

/// "A", "5", "F1", "Left", "PageUp", "Escape", "Minus", ...; the other way round nothing for an unknown name.
std::string_view nameOf(Key key);
std::optional<Key> keyFromName(std::string_view name);

}  // namespace ocelli
