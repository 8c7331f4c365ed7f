// The keys of the window of `ocelli feeds run --window`: what it does with each, and what its help says.
//
// Recipe for a new one: a row of the table in oc_core/feeds_window/feeds_keys.cpp.
#pragma once

#include <vector>

#include "oc_core/window/gui_window.h"

namespace ocelli {

/// What keys change.
struct FeedsWindowState : GuiWindowState {
  bool hasRedErased = false;
  bool hasLabels = true;
  bool hasOutlines = false;
  bool wantsPause = false;  ///< wishes, until the window has done them
  bool wantsStep = false;
  bool wantsSave = false;
};

struct FeedsKeyAction {
  std::vector<Key> keys;
  const char* shown;
  const char* meaning;
  void (*act)(FeedsWindowState& state);
};

const std::vector<FeedsKeyAction>& feedsKeyActions();

}  // namespace ocelli
