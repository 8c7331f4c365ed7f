// What keys and the buttons of a gamepad do in the window of `ocelli explore`: one table, which the window follows and
// its help shows. A new key is a row.
#pragma once

#include <span>

#include "oc_core/base/gamepad_state.h"
#include "oc_core/base/input_event.h"
#include "oc_core/explore_window/explore_window_state.h"
#include "oc_core/explore_window/explore_window_work.h"

namespace ocelli {

/// What the window does itself, once it has been wished for.
struct ExploreWindowWishes {
  bool saveImage = false;
  bool saveCamera = false;
  bool record = false;  ///< begin, or end
  bool fullscreen = false;
  bool close = false;
};

/// What keys act on.
struct ExploreKeyTarget {
  ExploreWindowState& state;
  ExploreWindowWork& work;
  ExploreWindowWishes& wishes;
  const WindowPicture* picture = nullptr;  ///< null until there is one
};

/// A row: what a press does.
struct ExploreKeyAction {
  const char* group;  ///< a heading of the help
  const char* keys;   ///< how the help names the key and those that belong to it; empty: not listed by itself
  const char* meaning;
  Key key;
  bool shift = false;
  bool control = false;
  int argument = 0;  ///< for `act`
  void (*act)(ExploreKeyTarget& target, int argument) = nullptr;
  int padButton = -1;    ///< of GamepadState::buttons; -1 for none
  const char* pad = "";  ///< how the help names that
};

/// A row: what moves as long as a key is held.
struct ExploreHeldKey {
  const char* group;
  const char* keys;
  const char* meaning;
  Key key;
  float WindowMotion::*part = nullptr;
  float amount = 1;
  const char* pad = "";
};

/// What the pointer does, for the help.
struct ExplorePointerRow {
  const char* what;
  const char* meaning;
};

std::span<const ExploreHeldKey> exploreHeldKeys();
std::span<const ExploreKeyAction> exploreKeyActions();
std::span<const ExplorePointerRow> explorePointerRows();

/// Null for a key that does nothing by being pressed.
const ExploreKeyAction* exploreActionOf(const KeyEvent& event);
const ExploreKeyAction* exploreActionOfPadButton(int button);

/// Changes an option of the constructor by `steps`, within its range.
void changeExploreField(ExploreKeyTarget& target, size_t row, double steps);

}  // namespace ocelli
