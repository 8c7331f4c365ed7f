#include "display_sim/viewer/effect_form.h"

#include <imgui.h>

#include "display_sim/viewer/effect_choice.h"
#include "display_sim/viewer/gui_pieces.h"
#include "oc_core/shade/effects.h"

namespace ocelli {
namespace {

void drawEffects(ViewerState& state) {
  if (!ImGui::BeginCombo("effect", state.effect.effect.c_str())) {
    return;
  }
  for (const Effect& effect : shadeEffects()) {
    if (ImGui::Selectable(effect.name, state.effect.effect == effect.name)) {
      chooseEffect(state, effect.name);
    }
    if (ImGui::IsItemHovered()) {
      ImGui::SetTooltip("%s", effect.description);
    }
  }
  ImGui::EndCombo();
}

void drawWays(ViewerState& state) {
  const std::string chosen = chosenWay(state);
  if (!ImGui::BeginCombo("by", chosen.c_str(), ImGuiComboFlags_HeightLarge)) {
    return;
  }
  if (ImGui::Selectable("the camera above", state.effect.way.empty())) {
    chooseEffectWay(state, "");
  }
  for (const std::string& way : effectWayNames(state.effect.effect)) {
    if (ImGui::Selectable(way.c_str(), state.effect.way == way)) {
      chooseEffectWay(state, way);
    }
  }
  ImGui::EndCombo();
}

}  // namespace

void drawEffectForm(const PanelDrawing& drawing, float valueWidth) {
  ViewerState& state = drawing.state;
  sectionTitle("Effect");
  ImGui::PushItemWidth(valueWidth);
  drawEffects(state);
  drawWays(state);
  ImGui::PopItemWidth();
}

}  // namespace ocelli
