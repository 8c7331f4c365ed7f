// The keys of the window of `ocelli sea view`: what it does with each, and what its help says.
//
// Recipe for a new one: a row of the tables in oc_core/sea_window/sea_keys.cpp.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "oc_core/base/input_event.h"
#include "oc_core/sea/sea_visit.h"
#include "oc_core/window/gui_window.h"

namespace ocelli {

/// What keys may change besides the visit.
struct SeaWindowState : GuiWindowState {
  bool hasMap = true;
};

/// A key that does something as long as it is held.
struct SeaHeldKey {
  std::vector<Key> keys;
  const char* shown;
  const char* meaning;
  /// `amount`: seconds, more with Shift.
  void (*move)(SeaVisit& visit, double amount);
};

struct SeaKeyAction {
  std::vector<Key> keys;
  const char* shown;
  const char* meaning;
  void (*act)(SeaVisit& visit, SeaWindowState& state);
};

const std::vector<SeaHeldKey>& seaHeldKeys();
const std::vector<SeaKeyAction>& seaKeyActions();

/// What the mouse does, for the help.
struct SeaPointerLine {
  const char* shown;
  const char* meaning;
};
std::span<const SeaPointerLine> seaPointerLines();

}  // namespace ocelli
