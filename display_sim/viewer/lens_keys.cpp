#include "display_sim/viewer/lens_keys.h"

#include "display_sim/viewer/lens_choice.h"

namespace ocelli {
namespace {

constexpr double kStepPixels = 8;  // of the reference image
constexpr double kFinePixels = 1;
constexpr double kZoomFactor = 1.1;
constexpr double kWidthFactor = 1.15;

/// Edits the chosen lens, unless it is locked.
template <class Edit>
PaneKeyOutcome editChosen(ViewerState& state, const Edit& edit) {
  if (!state.lenses.chosen) {
    return kKeyMeansElsewhere;
  }
  const size_t lens = *state.lenses.chosen;
  if (isLocked(state, lens)) {
    return {true, "this lens is locked: L unlocks it"};
  }
  edit(state.work.camera.gpc, lens);
  lensesChanged(state);
  return kKeyUsed;
}

template <int kRight, int kDown>
PaneKeyOutcome move(ViewerState& state, double pixels) {
  return editChosen(state, [&](GpcLayout& layout, size_t lens) {
    const glm::dvec2 size = lensImageSize(state);
    moveLens(layout, lens, glm::dvec2(layout.regions[lens].center) + pixels * glm::dvec2(kRight, kDown) / size, size);
  });
}
template <int kRight, int kDown>
PaneKeyOutcome step(ViewerState& state) {
  return move<kRight, kDown>(state, kStepPixels);
}
template <int kRight, int kDown>
PaneKeyOutcome fineStep(ViewerState& state) {
  return move<kRight, kDown>(state, kFinePixels);
}

template <int kWider, int kTaller>
PaneKeyOutcome grow(ViewerState& state) {
  return editChosen(state, [&](GpcLayout& layout, size_t lens) {
    const glm::dvec2 size = lensImageSize(state);
    sizeLens(layout, lens, glm::dvec2(layout.regions[lens].extent) + kStepPixels * glm::dvec2(kWider, kTaller) / size,
             size);
  });
}

PaneKeyOutcome zoomIn(ViewerState& state) {
  return editChosen(state, [](GpcLayout& layout, size_t lens) {
    zoomLens(layout, lens, static_cast<double>(layout.regions[lens].zoom) * kZoomFactor);
  });
}
PaneKeyOutcome zoomOut(ViewerState& state) {
  return editChosen(state, [](GpcLayout& layout, size_t lens) {
    zoomLens(layout, lens, static_cast<double>(layout.regions[lens].zoom) / kZoomFactor);
  });
}
PaneKeyOutcome widen(ViewerState& state) {
  return editChosen(state, [](GpcLayout& layout, size_t lens) {
    widenLens(layout, lens, static_cast<double>(layout.regions[lens].transitionWidth) * kWidthFactor);
  });
}
PaneKeyOutcome narrow(ViewerState& state) {
  return editChosen(state, [](GpcLayout& layout, size_t lens) {
    widenLens(layout, lens, static_cast<double>(layout.regions[lens].transitionWidth) / kWidthFactor);
  });
}

PaneKeyOutcome add(ViewerState& state) {
  return {true, addLensSomewhere(state) ? "" : "there is no room for another lens"};
}

PaneKeyOutcome removeChosen(ViewerState& state) {
  if (state.lenses.chosen && !isLocked(state, *state.lenses.chosen)) {
    removeLensOf(state, *state.lenses.chosen);
    return kKeyUsed;
  }
  return editChosen(state, [](GpcLayout&, size_t) {});
}

PaneKeyOutcome toggleLock(ViewerState& state) {
  if (!state.lenses.chosen) {
    return kKeyMeansElsewhere;
  }
  lockLens(state, *state.lenses.chosen, !isLocked(state, *state.lenses.chosen));
  return kKeyUsed;
}

PaneKeyOutcome toggleRates(ViewerState& state) {
  state.lenses.rates = !state.lenses.rates;
  return kKeyUsed;
}

PaneKeyOutcome letGo(ViewerState& state) {
  const bool held = state.lenses.chosen.has_value();
  state.lenses.chosen.reset();
  return {held, ""};
}

/// One after the other, and then out of the pane, so that keys alone get everywhere.
PaneKeyOutcome chooseNext(ViewerState& state) {
  std::optional<size_t>& chosen = state.lenses.chosen;
  const size_t next = chosen ? *chosen + 1 : 0;
  chosen = next < state.work.camera.gpc.regions.size() ? std::optional(next) : std::nullopt;
  return {chosen.has_value(), ""};
}
PaneKeyOutcome choosePrevious(ViewerState& state) {
  std::optional<size_t>& chosen = state.lenses.chosen;
  const size_t beyond = chosen.value_or(state.work.camera.gpc.regions.size());
  chosen = beyond > 0 ? std::optional(beyond - 1) : std::nullopt;
  return {chosen.has_value(), ""};
}

}  // namespace

const std::vector<PaneKey>& lensKeys() {
  static const std::vector<PaneKey> keys{
      {Key::kTab, chooseNext, "Tab  Shift + Tab", "next, previous lens; then the next pane"},
      {Key::kTab, choosePrevious, "", "", true},
      {Key::kLeft, step<-1, 0>, "Arrows", "move the chosen lens; Ctrl: by a pixel"},
      {Key::kRight, step<1, 0>, "", ""},
      {Key::kUp, step<0, -1>, "", ""},
      {Key::kDown, step<0, 1>, "", ""},
      {Key::kLeft, fineStep<-1, 0>, "", "", false, true},
      {Key::kRight, fineStep<1, 0>, "", "", false, true},
      {Key::kUp, fineStep<0, -1>, "", "", false, true},
      {Key::kDown, fineStep<0, 1>, "", "", false, true},
      {Key::kRight, grow<1, 0>, "Shift + arrows", "wider, narrower, taller, lower", true},
      {Key::kLeft, grow<-1, 0>, "", "", true},
      {Key::kUp, grow<0, 1>, "", "", true},
      {Key::kDown, grow<0, -1>, "", "", true},
      {Key::kEqual, zoomIn, "+  -", "zoom of the lens"},
      {Key::kEqual, zoomIn, "", "", true},
      {Key::kPageUp, zoomIn, "", ""},
      {Key::kMinus, zoomOut, "", ""},
      {Key::kPageDown, zoomOut, "", ""},
      {Key::kComma, narrow, ",  .", "narrower, wider transition"},
      {Key::kPeriod, widen, "", ""},
      {Key::kA, add, "A  Insert", "add a lens where there is room"},
      {Key::kInsert, add, "", ""},
      {Key::kDelete, removeChosen, "Delete", "remove the lens"},
      {Key::kBackspace, removeChosen, "", ""},
      {Key::kL, toggleLock, "L", "lock, unlock the lens"},
      {Key::kR, toggleRates, "R", "sampling rates over the picture"},
      {Key::kEscape, letGo, "Escape", "choose no lens: keys turn the view"},
  };
  return keys;
}

const std::vector<PointerBinding>& lensPointerBindings() {
  static const std::vector<PointerBinding> bindings{
      {"Click", "add a lens"},
      {"Drag", "a lens: move; its corner: size"},
      {"Drag the dashes", "width of the transition"},
      {"Wheel over it", "its zoom"},
  };
  return bindings;
}

PaneKeyOutcome applyLensKey(ViewerState& state, const KeyEvent& event) {
  return hasLenses(state) ? applyPaneKey(lensKeys(), Pane::kLenses, state, event) : kKeyMeansElsewhere;
}

}  // namespace ocelli
