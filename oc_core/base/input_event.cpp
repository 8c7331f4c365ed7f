#include "oc_core/base/input_event.h"

#include <algorithm>
#include <array>

namespace ocelli {
namespace {

// In the order of Key.
constexpr std::array<std::string_view, kKeyCount> kNames{
    "A",     "B",         "C",     "D",     "E",     "F",     "G",      "H",        "I",      "J",      "K",      "L",
    "M",     "N",         "O",     "P",     "Q",     "R",     "S",      "T",        "U",      "V",      "W",      "X",
    "Y",     "Z",         "0",     "1",     "2",     "3",     "4",      "5",        "6",      "7",      "8",      "9",
    "F1",    "F2",        "F3",    "F4",    "F5",    "F6",    "F7",     "F8",       "F9",     "F10",    "F11",    "F12",
    "Left",  "Right",     "Up",    "Down",  "Home",  "End",   "PageUp", "PageDown", "Insert", "Delete", "Escape", "Tab",
    "Enter", "Backspace", "Space", "Minus", "Equal", "Comma", "Period", "Slash"};

}  // namespace

std::string_view nameOf(Key key) {
  return kNames[static_cast<size_t>(key)];
}

std::optional<Key> keyFromName(std::string_view name) {
  const auto* found = std::find(kNames.begin(), kNames.end(), name);
  return found == kNames.end() ? std::nullopt : std::optional(static_cast<Key>(found - kNames.begin()));
}

}  // namespace ocelli
