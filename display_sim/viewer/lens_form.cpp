#include "display_sim/viewer/lens_form.h"

#include <fmt/format.h>
#include <imgui.h>

#include "display_sim/viewer/gui_pieces.h"
#include "display_sim/viewer/lens_choice.h"

namespace ocelli {
namespace {

void tip(const char* text) {
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("%s", text);
  }
}

/// A pair of shares of the image.
bool dragPair(const char* name, glm::vec2& value) {
  return ImGui::DragFloat2(name, &value.x, 0.002f, 0, 1, "%.4f", ImGuiSliderFlags_AlwaysClamp);
}

void drawSampling(ViewerState& state) {
  GpcLayout& layout = state.work.camera.gpc;
  if (!ImGui::BeginCombo("sampling", layout.sampling->name)) {
    return;
  }
  for (const GpcSampling& each : gpcSamplings()) {
    if (ImGui::Selectable(each.name, layout.sampling == &each)) {
      setLensSampling(layout, each);
      lensesChanged(state);
    }
    tip(each.meaning);
  }
  ImGui::EndCombo();
}

/// Fields of one lens; true where it is to be removed.
bool drawNumbers(ViewerState& state, size_t lens) {
  GpcLayout& layout = state.work.camera.gpc;
  const glm::dvec2 size = lensImageSize(state);
  GpcRegion wanted = layout.regions[lens];
  const bool locked = isLocked(state, lens);
  bool changed = false;
  ImGui::BeginDisabled(locked);
  if (dragPair("centre", wanted.center)) {
    moveLens(layout, lens, glm::dvec2(wanted.center), size);
    changed = true;
  }
  tip("Where its middle is, in shares of the image's width and height");
  if (dragPair("extent", wanted.extent)) {
    sizeLens(layout, lens, glm::dvec2(wanted.extent), size);
    changed = true;
  }
  tip("Its width and height, in the same shares");
  if (ImGui::DragFloat("zoom", &wanted.zoom, 0.02f, static_cast<float>(GpcRegion::kMinZoom),
                       static_cast<float>(GpcRegion::kMaxZoom), "%.3f x",
                       ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic)) {
    zoomLens(layout, lens, static_cast<double>(wanted.zoom));
    changed = true;
  }
  tip("Samples for each one of a pinhole, along either axis");
  if (ImGui::DragFloat("transition", &wanted.transitionWidth, 0.01f, static_cast<float>(GpcRegion::kMinTransition),
                       static_cast<float>(GpcRegion::kMaxTransition), "%.3f",
                       ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic)) {
    widenLens(layout, lens, static_cast<double>(wanted.transitionWidth));
    changed = true;
  }
  tip("From its edge to where the image is the pinhole's again, in halves of its extent");
  const bool isRemoved = ImGui::Button("Remove");
  ImGui::EndDisabled();
  ImGui::SameLine();
  bool lock = locked;
  if (ImGui::Checkbox("locked", &lock)) {
    lockLens(state, lens, lock);
  }
  if (changed) {
    state.lenses.chosen = lens;
    lensesChanged(state);
  }
  return isRemoved;
}

void drawLenses(ViewerState& state) {
  std::optional<size_t> removed;
  for (size_t i = 0; i < state.work.camera.gpc.regions.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const std::string title =
        fmt::format("lens {}: {:.3g}x{}{}###lens", i + 1, state.work.camera.gpc.regions[i].zoom,
                    isLocked(state, i) ? ", locked" : "", state.lenses.chosen == i ? ", chosen" : "");
    ImGui::SetNextItemOpen(i < 2, ImGuiCond_Once);
    if (ImGui::TreeNodeEx(title.c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen) && drawNumbers(state, i)) {
      removed = i;
    }
    ImGui::PopID();
  }
  if (removed) {
    removeLensOf(state, *removed);
  }
}

}  // namespace

void LensForm::draw(const PanelDrawing& drawing, float valueWidth) {
  ViewerState& state = drawing.state;
  ImGui::PushItemWidth(valueWidth);
  drawSampling(state);
  comboOf("drawn by", state.lenses.method, 2);
  drawLenses(state);
  ImGui::PopItemWidth();
  if (ImGui::Button("Add lens (A)")) {
    addLensSomewhere(state);
  }
  ImGui::SameLine();
  ImGui::Checkbox("rates (R)", &state.lenses.rates);
  tip("Sampling rates in false colours over the picture");
  if (ImGui::Button("Save lenses (Shift + S)")) {
    drawing.wishes.actions.push_back(ViewerAction::kSaveLenses);
  }
  ImGui::SetNextItemWidth(valueWidth);
  if (inputText("load file", file_) && !file_.empty()) {
    drawing.wishes.camera = file_;
  }
  tip("A camera's JSON file, as --camera takes it; Enter loads it. A file may be dropped onto the window, too");
  noteText(
      "Click into the picture of pane 6: a lens. Drag: move; corners: size; dashed edge: transition; wheel: zoom. "
      "Tab, arrows, + - , . A Delete L: the same by keys (H).");
}

}  // namespace ocelli
