// What keys do: one list, which the viewer follows and its help shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "display_sim/viewer/viewer_state.h"
#include "oc_core/base/input_event.h"

namespace ocelli {

enum class ViewerAction {
  // clang-format off
  kTurnLeft, kTurnRight, kTurnUp, kTurnDown, kMoveLeft, kMoveRight, kMoveUp, kMoveDown, kZoomIn, kZoomOut, kResetView,
  kNextPane, kPreviousPane, kMaximise1, kMaximise2, kMaximise3, kMaximise4, kMaximise5, kMaximise6, kMaximise7, kMaximise8,
  kShowAll,
  kNextCamera, kPreviousCamera, kWiderCell, kNarrowerCell, kReferenceToEye,
  kToggleRays, kToggleStraightRays, kToggleFrustum, kToggleCell, kToggleSamples, kToggleCloseUp,
  kNextQuantity, kNextImage,
  kNextContent, kToggleBlink,
  kRunOrStop, kSlower, kFaster, kStepBack, kStepForward, kToggleFollow, kNextProfile, kToggleSliced,
  kToggleEffect, kSwitchToTraced, kSwitchToDifference, kNextWay, kPreviousWay, kNextEffect, kPreviousEffect,
  kUndoTransfer, kRedoTransfer, kTypeTransferNumbers, kSaveTransfer,
  kHelp, kTogglePanel, kFocusPanel, kScreenshot, kSaveView, kSaveLenses, kEscape, kQuit,
  // clang-format on
};

struct KeyBinding {
  Key key;
  ViewerAction action;
  const char* group;  ///< a heading of the help
  const char* keys;   ///< how the help names the key, and those that belong to it; empty: not listed by itself
  const char* text;
  bool shift = false;
  bool control = false;
};

const std::vector<KeyBinding>& keyBindings();
std::optional<ViewerAction> actionOf(const KeyEvent& event);

/// What the pointer does, for the help.
struct PointerBinding {
  const char* what;
  const char* text;
};
const std::vector<PointerBinding>& pointerBindings();

/// Does what is a matter of the state alone; false for the others: screenshot, view, lenses, transfer
/// function, panel focus, its numbers, quit. Throws
/// InputError as the functions of viewer_state.h do.
bool applyAction(ViewerState& state, ViewerAction action);

}  // namespace ocelli
