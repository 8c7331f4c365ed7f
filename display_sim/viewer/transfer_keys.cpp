#include "display_sim/viewer/transfer_keys.h"

#include "display_sim/viewer/transfer_pointer.h"

namespace ocelli {
namespace {

constexpr double kValueStep = 0.01;  // of the values that show
constexpr double kOpacityStep = 0.02;
constexpr double kFinePart = 0.1;  // of these steps
constexpr double kAxisZoom = 1.25;

/// Edits the chosen point.
template <class Edit>
PaneKeyOutcome editPoint(ViewerState& state, const Edit& edit) {
  TransferEditor& editor = *state.volume.transfer;
  if (!editor.chosen()) {
    return kKeyMeansElsewhere;
  }
  edit(editor, *editor.chosen());
  return kKeyUsed;
}

template <int kRight, int kUp>
PaneKeyOutcome movePointBy(ViewerState& state, double steps) {
  return editPoint(state, [&](TransferEditor& editor, size_t index) {
    const TransferPoint& point = editor.points()[index];
    editor.movePoint(index, point.value + kRight * steps * kValueStep * state.volume.axis.width(),
                     point.opacity + kUp * steps * kOpacityStep);
  });
}
template <int kRight, int kUp>
PaneKeyOutcome pointStep(ViewerState& state) {
  return movePointBy<kRight, kUp>(state, 1);
}
template <int kRight, int kUp>
PaneKeyOutcome finePointStep(ViewerState& state) {
  return movePointBy<kRight, kUp>(state, kFinePart);
}

PaneKeyOutcome addPointBeside(ViewerState& state) {
  TransferEditor& editor = *state.volume.transfer;
  return {true, editor.addBeside(editor.chosen().value_or(0)) ? "" : kTooManyPoints};
}

PaneKeyOutcome removePointOf(ViewerState& state) {
  TransferEditor& editor = *state.volume.transfer;
  if (!editor.chosen()) {
    return kKeyMeansElsewhere;
  }
  return {true, editor.removePoint(*editor.chosen()) ? "" : "a transfer function has one point at the least"};
}

PaneKeyOutcome letPointGo(ViewerState& state) {
  const bool held = state.volume.transfer->chosen().has_value();
  state.volume.transfer->choose(std::nullopt);
  return {held, ""};
}

/// One after the other, and then out of the pane, so that keys alone get everywhere.
PaneKeyOutcome chooseNextPoint(ViewerState& state) {
  TransferEditor& editor = *state.volume.transfer;
  const size_t next = editor.chosen() ? *editor.chosen() + 1 : 0;
  editor.choose(next < editor.points().size() ? std::optional(next) : std::nullopt);
  return {editor.chosen().has_value(), ""};
}
PaneKeyOutcome choosePreviousPoint(ViewerState& state) {
  TransferEditor& editor = *state.volume.transfer;
  const size_t beyond = editor.chosen().value_or(editor.points().size());
  editor.choose(beyond > 0 ? std::optional(beyond - 1) : std::nullopt);
  return {editor.chosen().has_value(), ""};
}

PaneKeyOutcome zoomValues(ViewerState& state, double factor) {
  const TransferEditor& editor = *state.volume.transfer;
  ValueAxis& axis = state.volume.axis;
  const double around = editor.chosen() ? editor.points()[*editor.chosen()].value : axis.valueAt(0.5);
  axis = zoomedAxis(axis, state.volume.values, around, factor);
  return kKeyUsed;
}
PaneKeyOutcome fewerValues(ViewerState& state) {
  return zoomValues(state, kAxisZoom);
}
PaneKeyOutcome moreValues(ViewerState& state) {
  return zoomValues(state, 1 / kAxisZoom);
}

}  // namespace

const std::vector<PaneKey>& transferKeys() {
  static const std::vector<PaneKey> keys{
      {Key::kTab, chooseNextPoint, "Tab  Shift + Tab", "next, previous point; then the next pane"},
      {Key::kTab, choosePreviousPoint, "", "", true},
      {Key::kLeft, pointStep<-1, 0>, "Arrows", "move the chosen point; Ctrl: a tenth as far"},
      {Key::kRight, pointStep<1, 0>, "", ""},
      {Key::kUp, pointStep<0, 1>, "", ""},
      {Key::kDown, pointStep<0, -1>, "", ""},
      {Key::kLeft, finePointStep<-1, 0>, "", "", false, true},
      {Key::kRight, finePointStep<1, 0>, "", "", false, true},
      {Key::kUp, finePointStep<0, 1>, "", "", false, true},
      {Key::kDown, finePointStep<0, -1>, "", "", false, true},
      {Key::kA, addPointBeside, "A  Insert", "add a point beside it"},
      {Key::kInsert, addPointBeside, "", ""},
      {Key::kDelete, removePointOf, "Delete", "remove the point"},
      {Key::kBackspace, removePointOf, "", ""},
      {Key::kEqual, fewerValues, "+  -  Home", "fewer, more, all of the values"},
      {Key::kEqual, fewerValues, "", "", true},
      {Key::kPageUp, fewerValues, "", ""},
      {Key::kMinus, moreValues, "", ""},
      {Key::kPageDown, moreValues, "", ""},
      {Key::kEscape, letPointGo, "Escape", "choose no point: arrows move the values"},
  };
  return keys;
}

PaneKeyOutcome applyTransferKey(ViewerState& state, const KeyEvent& event) {
  if (state.volume.transfer && !event.pressed) {
    state.volume.transfer->endStep();
  }
  return state.volume.transfer ? applyPaneKey(transferKeys(), Pane::kTransfer, state, event) : kKeyMeansElsewhere;
}

}  // namespace ocelli
