#include "display_sim/viewer/lens_choice.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ocelli {

glm::dvec2 lensImageSize(const ViewerState& state) {
  return {state.work.width, state.work.height};
}

bool isLocked(const ViewerState& state, size_t lens) {
  return lens < state.lenses.locked.size() && state.lenses.locked[lens];
}

void lockLens(ViewerState& state, size_t lens, bool locked) {
  std::vector<bool>& all = state.lenses.locked;
  all.resize(std::max(all.size(), lens + 1));
  all[lens] = locked;
}

void lensesChanged(ViewerState& state) {
  state.lenses.changedAt = state.seconds;
}

void followLenses(ViewerState& state, bool atOnce) {
  if (state.lenses.changedAt && (atOnce || state.seconds - *state.lenses.changedAt >= kLensRestSeconds)) {
    cameraChanged(state);
  }
}

bool addLensAt(ViewerState& state, const glm::dvec2& at) {
  GpcLayout& layout = state.work.camera.gpc;
  GpcRegion lens = state.lenses.chosen ? layout.regions[*state.lenses.chosen] : kNewLens;
  lens.center = glm::vec2(at);
  const std::optional<size_t> added = addLens(layout, lens, lensImageSize(state));
  if (!added) {
    return false;
  }
  state.lenses.chosen = added;
  lensesChanged(state);
  return true;
}

bool addLensSomewhere(ViewerState& state) {
  constexpr int kSteps = 16;
  std::vector<glm::dvec2> places;
  for (int y = 0; y <= kSteps; ++y) {
    for (int x = 0; x <= kSteps; ++x) {
      places.push_back(glm::dvec2(x, y) / static_cast<double>(kSteps));
    }
  }
  const glm::dvec2 size = lensImageSize(state);
  const auto fromMiddle = [&](const glm::dvec2& place) { return glm::length((place - 0.5) * size); };
  std::stable_sort(places.begin(), places.end(),
                   [&](const glm::dvec2& a, const glm::dvec2& b) { return fromMiddle(a) < fromMiddle(b); });
  return std::any_of(places.begin(), places.end(), [&](const glm::dvec2& place) { return addLensAt(state, place); });
}

void removeLensOf(ViewerState& state, size_t lens) {
  removeLens(state.work.camera.gpc, lens);
  std::vector<bool>& locked = state.lenses.locked;
  if (lens < locked.size()) {
    locked.erase(locked.begin() + static_cast<std::ptrdiff_t>(lens));
  }
  state.lenses.chosen.reset();
  lensesChanged(state);
}

void openLensPane(ViewerState& state) {
  if (!hasLenses(state)) {
    chooseCamera(state, "gpc");
  }
  state.maximised = Pane::kLenses;
  state.active = Pane::kLenses;
}

}  // namespace ocelli
