// The keys of the window of `ocelli feeds edit`: what it does with each, and what its help says.
//
// Recipe for a new one: a row of the table in oc_core/feeds_editor_window/face_keys.cpp.
#pragma once

#include <span>
#include <vector>

#include "oc_core/feeds_editor/face_editor.h"
#include "oc_core/window/gui_window.h"

namespace ocelli {

/// What keys may change besides the editor.
struct FaceWindowState : GuiWindowState {
  bool wantsSave = false;  ///< wishes, until the window has done them
  bool wantsAll = false;   ///< the plan shows all again
};

struct FaceKeyAction {
  std::vector<Key> keys;
  bool hasControl = false;  ///< with the key held
  const char* shown;
  const char* meaning;
  void (*act)(FaceEditor& editor, FaceWindowState& state, const Modifiers& modifiers);
};

const std::vector<FaceKeyAction>& faceKeyActions();

/// What the mouse does, for the help.
struct FacePointerLine {
  const char* shown;
  const char* meaning;
};
std::span<const FacePointerLine> facePointerLines();

}  // namespace ocelli
