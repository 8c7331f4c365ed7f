#include "display_sim/viewer/viewer_keys.h"

#include <algorithm>
#include <array>

#include "display_sim/viewer/effect_choice.h"
#include "display_sim/viewer/lens_choice.h"

namespace ocelli {
namespace {

constexpr double kTurnStep = kPi / 36;  // 5 degrees
constexpr double kMoveStep = 0.05;      // pane heights
constexpr double kZoomStep = 1.15;
constexpr double kCellStep = 1.25;
constexpr double kSpeedStep = 2;

constexpr const char* kMove = "Moving the pane with the blue title";
constexpr const char* kPanesGroup = "Panes";
constexpr const char* kCameraGroup = "Camera";
constexpr const char* kShow = "What panes show";
constexpr const char* kDisplayGroup = "Display";
constexpr const char* kEffectGroup = "Effect: reflections and others";
constexpr const char* kVolumeGroup = "Volume: its transfer function";
constexpr const char* kWindow = "Window and files";

ReferenceShown::Quantity next(ReferenceShown::Quantity quantity) {
  using Quantity = ReferenceShown::Quantity;
  return quantity == Quantity::kDisplacement ? Quantity::kColor : Quantity(static_cast<int>(quantity) + 1);
}

ReconstructionShown::Content next(ReconstructionShown::Content content) {
  using Content = ReconstructionShown::Content;
  return content == Content::kBlink ? Content::kMarked : Content(static_cast<int>(content) + 1);
}

void toggle(bool& flag) {
  flag = !flag;
}

void activate(ViewerState& state, Pane pane) {
  state.active = pane;
  if (state.maximised) {
    state.maximised = pane;
  }
}

void maximise(ViewerState& state, Pane pane) {
  state.maximised = pane;
  state.active = pane;
}

Pane neighbour(const ViewerState& state, size_t step) {
  Pane pane = state.active;
  do {
    pane = kPanes[(static_cast<size_t>(pane) + step) % kPaneCount];
  } while (!isOffered(state, pane));
  return pane;
}

/// Shows this in the effect pane, or the chosen way where it is shown already.
void switchTo(ViewerState& state, EffectShown::Content content) {
  state.effect.content = state.effect.content == content ? EffectShown::Content::kByWay : content;
}

/// What moves the active pane, in steps.
struct Move {
  ViewerAction action;
  void (*apply)(ViewerState& state, Pane pane);
};
constexpr std::array kMoves{
    Move{ViewerAction::kTurnLeft, [](ViewerState& state, Pane pane) { orbitPane(state, pane, -kTurnStep, 0); }},
    Move{ViewerAction::kTurnRight, [](ViewerState& state, Pane pane) { orbitPane(state, pane, kTurnStep, 0); }},
    Move{ViewerAction::kTurnUp, [](ViewerState& state, Pane pane) { orbitPane(state, pane, 0, kTurnStep); }},
    Move{ViewerAction::kTurnDown, [](ViewerState& state, Pane pane) { orbitPane(state, pane, 0, -kTurnStep); }},
    Move{ViewerAction::kMoveLeft, [](ViewerState& state, Pane pane) { panPane(state, pane, -kMoveStep, 0); }},
    Move{ViewerAction::kMoveRight, [](ViewerState& state, Pane pane) { panPane(state, pane, kMoveStep, 0); }},
    Move{ViewerAction::kMoveUp, [](ViewerState& state, Pane pane) { panPane(state, pane, 0, kMoveStep); }},
    Move{ViewerAction::kMoveDown, [](ViewerState& state, Pane pane) { panPane(state, pane, 0, -kMoveStep); }},
    Move{ViewerAction::kZoomIn, [](ViewerState& state, Pane pane) { zoomPane(state, pane, kZoomStep); }},
    Move{ViewerAction::kZoomOut, [](ViewerState& state, Pane pane) { zoomPane(state, pane, 1 / kZoomStep); }},
    Move{ViewerAction::kResetView, resetPane},
};

void leave(ViewerState& state) {
  if (state.help) {
    state.help = false;
  } else {
    state.maximised.reset();
  }
}

}  // namespace

const std::vector<KeyBinding>& keyBindings() {
  using enum ViewerAction;
  static const std::vector<KeyBinding> bindings{
      {Key::kLeft, kTurnLeft, kMove, "Arrows", "turn around the target"},
      {Key::kRight, kTurnRight, kMove, "", ""},
      {Key::kUp, kTurnUp, kMove, "", ""},
      {Key::kDown, kTurnDown, kMove, "", ""},
      {Key::kLeft, kMoveLeft, kMove, "Shift + arrows", "move sideways, up and down", true},
      {Key::kRight, kMoveRight, kMove, "", "", true},
      {Key::kUp, kMoveUp, kMove, "", "", true},
      {Key::kDown, kMoveDown, kMove, "", "", true},
      {Key::kEqual, kZoomIn, kMove, "+  PageUp", "nearer"},
      {Key::kEqual, kZoomIn, kMove, "", "", true},
      {Key::kPageUp, kZoomIn, kMove, "", ""},
      {Key::kMinus, kZoomOut, kMove, "-  PageDown", "farther away"},
      {Key::kPageDown, kZoomOut, kMove, "", ""},
      {Key::kHome, kResetView, kMove, "Home", "back to the start"},

      {Key::kTab, kNextPane, kPanesGroup, "Tab  Shift + Tab", "next, previous pane"},
      {Key::kTab, kPreviousPane, kPanesGroup, "", "", true},
      {Key::k1, kMaximise1, kPanesGroup, "1  2 ... 8", "one pane alone; 5: effect, 6: lenses, 7: volume"},
      {Key::k2, kMaximise2, kPanesGroup, "", ""},
      {Key::k3, kMaximise3, kPanesGroup, "", ""},
      {Key::k4, kMaximise4, kPanesGroup, "", ""},
      {Key::k5, kMaximise5, kPanesGroup, "", ""},
      {Key::k6, kMaximise6, kPanesGroup, "", ""},
      {Key::k7, kMaximise7, kPanesGroup, "", ""},
      {Key::k8, kMaximise8, kPanesGroup, "", ""},
      {Key::k0, kShowAll, kPanesGroup, "0", "all panes"},

      {Key::kC, kNextCamera, kCameraGroup, "C  Shift + C", "next, previous camera"},
      {Key::kC, kPreviousCamera, kCameraGroup, "", "", true},
      {Key::kW, kWiderCell, kCameraGroup, "W  N", "wider, narrower view cell"},
      {Key::kN, kNarrowerCell, kCameraGroup, "", ""},
      {Key::kE, kReferenceToEye, kCameraGroup, "E", "reference view := your eye"},

      {Key::kR, kToggleRays, kShow, "R  T", "scene: rays, straight ones too"},
      {Key::kT, kToggleStraightRays, kShow, "", ""},
      {Key::kF, kToggleFrustum, kShow, "F  X  D", "scene: frustum, view cell, samples"},
      {Key::kX, kToggleCell, kShow, "", ""},
      {Key::kD, kToggleSamples, kShow, "", ""},
      {Key::kV, kToggleCloseUp, kShow, "V", "scene: from close by, from afar"},
      {Key::kQ, kNextQuantity, kShow, "Q", "image: colour, depth, displacement"},
      {Key::kI, kNextImage, kShow, "I", "image: next of a union"},
      {Key::kM, kNextContent, kShow, "M", "reconstruction: marked, plain, truth, ..."},
      {Key::kB, kToggleBlink, kShow, "B", "reconstruction: blink with the truth"},

      {Key::kSpace, kRunOrStop, kDisplayGroup, "Space", "run, stop"},
      {Key::kComma, kSlower, kDisplayGroup, ",  .", "half, double speed"},
      {Key::kPeriod, kFaster, kDisplayGroup, "", ""},
      {Key::kComma, kStepBack, kDisplayGroup, "Shift + ,  .", "one slice back, on", true},
      {Key::kPeriod, kStepForward, kDisplayGroup, "", "", true},
      {Key::kL, kToggleFollow, kDisplayGroup, "L", "observer linked to your eye"},
      {Key::kP, kNextProfile, kDisplayGroup, "P", "next display"},
      {Key::kZ, kToggleSliced, kDisplayGroup, "Z", "shows the mesh or the scene itself"},

      {Key::kK, kSwitchToTraced, kEffectGroup, "K  Shift + K", "traced or by the way, their difference"},
      {Key::kK, kSwitchToDifference, kEffectGroup, "", "", true},
      {Key::kU, kNextWay, kEffectGroup, "U  Y", "next way, effect; Shift: previous"},
      {Key::kU, kPreviousWay, kEffectGroup, "", "", true},
      {Key::kY, kNextEffect, kEffectGroup, "", ""},
      {Key::kY, kPreviousEffect, kEffectGroup, "", "", true},
      {Key::kO, kToggleEffect, kEffectGroup, "O", "the effect pane on, off"},

      {Key::kZ, kUndoTransfer, kVolumeGroup, "Ctrl + Z  Y", "undo, redo a change of the transfer function", false,
       true},
      {Key::kY, kRedoTransfer, kVolumeGroup, "", "", false, true},
      {Key::kZ, kRedoTransfer, kVolumeGroup, "", "", true, true},
      {Key::kEnter, kTypeTransferNumbers, kVolumeGroup, "Enter", "type the numbers of a point"},
      {Key::kS, kSaveTransfer, kVolumeGroup, "Ctrl + S", "save the transfer function, for --transfer", false, true},

      {Key::kH, kHelp, kWindow, "H  F1", "this help"},
      {Key::kF1, kHelp, kWindow, "", ""},
      {Key::kG, kTogglePanel, kWindow, "G", "panel on the left"},
      {Key::kF6, kFocusPanel, kWindow, "F6", "into the panel; Escape leaves"},
      {Key::kS, kScreenshot, kWindow, "S", "save an image of the window"},
      {Key::kJ, kSaveView, kWindow, "J", "save your view, for --view"},
      {Key::kS, kSaveLenses, kWindow, "Shift + S", "save the lenses, for --camera", true},
      {Key::kEscape, kEscape, kWindow, "Escape", "leave help, a message, or a lone pane"},
      {Key::kQ, kQuit, kWindow, "Ctrl + Q", "quit", false, true},
  };
  return bindings;
}

std::optional<ViewerAction> actionOf(const KeyEvent& event) {
  const auto& bindings = keyBindings();
  const auto found = std::find_if(bindings.begin(), bindings.end(), [&](const KeyBinding& b) {
    return b.key == event.key && b.shift == event.modifiers.shift && b.control == event.modifiers.control;
  });
  return event.pressed && !event.modifiers.alt && found != bindings.end() ? std::optional(found->action) : std::nullopt;
}

const std::vector<PointerBinding>& pointerBindings() {
  static const std::vector<PointerBinding> bindings{
      {"Left drag", "turn; move an image"},
      {"Right or Shift drag", "move sideways"},
      {"Wheel", "nearer, farther away"},
      {"Over the image", "read a sample, see its ray"},
      {"Drop a file", "open it: scene, view, camera, roles or transfer function"},
  };
  return bindings;
}

bool applyAction(ViewerState& state, ViewerAction action) {
  using enum ViewerAction;
  using Content = ReconstructionShown::Content;
  const auto move = std::find_if(kMoves.begin(), kMoves.end(), [&](const Move& m) { return m.action == action; });
  if (move != kMoves.end()) {
    move->apply(state, state.active);
    return true;
  }
  switch (action) {
    case kNextPane:
      activate(state, neighbour(state, 1));
      return true;
    case kPreviousPane:
      activate(state, neighbour(state, kPaneCount - 1));
      return true;
    case kMaximise1:
      maximise(state, Pane::kScene);
      return true;
    case kMaximise2:
      maximise(state, Pane::kReference);
      return true;
    case kMaximise3:
      maximise(state, Pane::kReconstruction);
      return true;
    case kMaximise4:
      maximise(state, Pane::kDisplay);
      return true;
    case kMaximise5:
      openEffectPane(state);
      return true;
    case kMaximise6:
      openLensPane(state);
      return true;
    case kMaximise7:
      maximise(state, Pane::kVolume);
      return true;
    case kMaximise8:
      maximise(state, Pane::kTransfer);
      return true;
    case kShowAll:
      state.maximised.reset();
      return true;
    case kNextCamera:
      chooseNextCamera(state, 1);
      return true;
    case kPreviousCamera:
      chooseNextCamera(state, -1);
      return true;
    case kWiderCell:
      chooseCellSide(state, static_cast<double>(state.work.camera.cellSideRadii) * kCellStep);
      return true;
    case kNarrowerCell:
      chooseCellSide(state, static_cast<double>(state.work.camera.cellSideRadii) / kCellStep);
      return true;
    case kReferenceToEye:
      moveReferenceToEye(state);
      return true;
    case kToggleRays:
      toggle(state.scene.rays);
      return true;
    case kToggleStraightRays:
      toggle(state.scene.straightRays);
      return true;
    case kToggleFrustum:
      toggle(state.scene.frustum);
      return true;
    case kToggleCell:
      toggle(state.scene.cell);
      return true;
    case kToggleSamples:
      toggle(state.scene.samples);
      return true;
    case kToggleCloseUp:
      toggleCloseUp(state);
      return true;
    case kNextQuantity:
      state.reference.quantity = next(state.reference.quantity);
      return true;
    case kNextImage:
      ++state.reference.image;  // the viewer, which knows how many there are, begins again
      return true;
    case kNextContent:
      state.reconstruction.content = next(state.reconstruction.content);
      return true;
    case kToggleBlink:
      state.reconstruction.content =
          state.reconstruction.content == Content::kBlink ? Content::kMarked : Content::kBlink;
      return true;
    case kRunOrStop:
      toggle(state.display.running);
      return true;
    case kSlower:
      changeSpeed(state, 1 / kSpeedStep);
      return true;
    case kFaster:
      changeSpeed(state, kSpeedStep);
      return true;
    case kStepBack:
      stepDisplay(state, -1);
      return true;
    case kStepForward:
      stepDisplay(state, 1);
      return true;
    case kToggleFollow:
      toggle(state.display.followsEye);
      return true;
    case kNextProfile:
      chooseNextProfile(state);
      return true;
    case kToggleSliced:
      toggle(state.work.sliceScene);
      displayChanged(state);
      return true;
    case kToggleEffect:
      if (state.effect.on) {
        closeEffectPane(state);
      } else {
        state.effect.on = true;
        activate(state, Pane::kEffect);
      }
      return true;
    case kSwitchToTraced:
      switchTo(state, EffectShown::Content::kByTracing);
      return true;
    case kSwitchToDifference:
      switchTo(state, EffectShown::Content::kDifference);
      return true;
    case kNextWay:
      chooseNextEffectWay(state, 1);
      return true;
    case kPreviousWay:
      chooseNextEffectWay(state, -1);
      return true;
    case kNextEffect:
      chooseNextEffect(state, 1);
      return true;
    case kPreviousEffect:
      chooseNextEffect(state, -1);
      return true;
    case kUndoTransfer:
      if (state.volume.transfer) {
        state.volume.transfer->undo();
      }
      return true;
    case kRedoTransfer:
      if (state.volume.transfer) {
        state.volume.transfer->redo();
      }
      return true;
    case kHelp:
      toggle(state.help);
      return true;
    case kTogglePanel:
      toggle(state.panel);
      return true;
    case kEscape:
      leave(state);
      return true;
    case kTurnLeft:
    case kTurnRight:
    case kTurnUp:
    case kTurnDown:
    case kMoveLeft:
    case kMoveRight:
    case kMoveUp:
    case kMoveDown:
    case kZoomIn:
    case kZoomOut:
    case kResetView:  // done above
    case kFocusPanel:
    case kScreenshot:
    case kSaveView:
    case kSaveLenses:
    case kTypeTransferNumbers:
    case kSaveTransfer:
    case kQuit:
      return false;
  }
  return false;
}

}  // namespace ocelli
