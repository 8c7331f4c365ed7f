#include "display_sim/viewer/effect_choice.h"

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/shade/effects.h"

namespace ocelli {
namespace {

bool takesWay(const Effect& effect, const std::string& way) {
  try {
    effect.checkWay(way);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::string furtherOn(const std::vector<std::string>& names, const std::string& name, int step) {
  const auto count = static_cast<int>(names.size());
  const auto found = std::find(names.begin(), names.end(), name);
  if (count == 0) {
    return name;
  }
  if (found == names.end()) {
    return step > 0 ? names.front() : names.back();
  }
  const int at = static_cast<int>(found - names.begin()) + step;
  return names[static_cast<size_t>((at % count + count) % count)];
}

}  // namespace

std::vector<std::string> effectNames() {
  std::vector<std::string> names;
  for (const Effect& effect : shadeEffects()) {
    names.emplace_back(effect.name);
  }
  return names;
}

std::vector<std::string> effectWayNames(const std::string& effect) {
  return effect.empty() ? std::vector<std::string>() : offeredWays(shadeEffect(effect));
}

std::string chosenWay(const ViewerState& state) {
  const EffectShown& shown = state.effect;
  if (shown.effect.empty() || !shown.way.empty()) {
    return shown.way;
  }
  const Effect& effect = shadeEffect(shown.effect);
  if (takesWay(effect, state.work.camera.name)) {
    return state.work.camera.name;
  }
  const std::vector<std::string> offered = offeredWays(effect);
  return offered.empty() ? kTraced : offered.front();
}

void chooseEffect(ViewerState& state, const std::string& name) {
  const Effect& effect = shadeEffect(name);
  state.effect.on = true;
  state.effect.effect = name;
  if (!state.effect.way.empty() && !takesWay(effect, state.effect.way)) {
    state.effect.way.clear();
  }
}

void chooseEffectWay(ViewerState& state, const std::string& way) {
  if (!way.empty()) {
    if (state.effect.effect.empty()) {
      throw InputError("no effect is chosen that is drawn by \"" + way + "\"", "the effect pane",
                       "choose an effect first");
    }
    shadeEffect(state.effect.effect).checkWay(way);
  }
  state.effect.way = way;
}

void chooseNextEffect(ViewerState& state, int step) {
  chooseEffect(state, furtherOn(effectNames(), state.effect.effect, step));
}

void chooseNextEffectWay(ViewerState& state, int step) {
  if (!state.effect.effect.empty()) {
    chooseEffectWay(state, furtherOn(effectWayNames(state.effect.effect), chosenWay(state), step));
  }
}

void openEffectPane(ViewerState& state) {
  state.effect.on = true;
  state.maximised = Pane::kEffect;
  state.active = Pane::kEffect;
}

void closeEffectPane(ViewerState& state) {
  state.effect.on = false;
  leavePane(state, Pane::kEffect);
}

}  // namespace ocelli
