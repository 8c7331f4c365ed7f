#include "display_sim/viewer/volume_form.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "display_sim/viewer/gui_pieces.h"
#include "oc_core/base/printable_text.h"
#include "oc_core/image/color.h"
#include "oc_core/volume/transfer_presets.h"

namespace ocelli {
namespace {

void tip(const char* text) {
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("%s", text);
  }
}

/// Text of a file, as it stands in a format of printf.
std::string literalFormat(const std::string& text) {
  std::string format;
  for (const char each : printableText(text)) {
    format += each == '%' ? std::string("%%") : std::string(1, each);
  }
  return format;
}

/// A slider for a double; true where it was moved.
bool slider(const char* name, double& value, double least, double greatest, const char* format, int flags = 0) {
  auto number = static_cast<float>(value);
  if (!ImGui::SliderFloat(name, &number, static_cast<float>(least), static_cast<float>(greatest), format,
                          ImGuiSliderFlags_AlwaysClamp | flags)) {
    return false;
  }
  value = static_cast<double>(number);
  return true;
}

/// The least and the greatest value.
ValueRange rangeOf(const LoadedVolume& volume) {
  ValueRange range = volume.histogram.bounds;
  const double width = volume.histogram.binWidth();
  const VoxelType type = volume.scene.volume->type();
  const bool isWhole = type != VoxelType::kFloat32 && type != VoxelType::kFloat64;
  if (isWhole && std::abs(width - std::abs(volume.scene.volume->scale())) <= 1e-9 * width) {
    range.least += width / 2;  // each number has a bin, with itself in the middle
    range.greatest -= width / 2;
  }
  return range;
}

std::string sizeText(const LoadedVolume& volume) {
  const VolumeGrid& grid = volume.scene.volume->grid();
  const glm::dvec3 spacing = grid.spacing();
  const ValueRange range = rangeOf(volume);
  return fmt::format("{} x {} x {} voxels of {}, {:.4g} x {:.4g} x {:.4g} {}, values {:.6g} to {:.6g}", grid.size.x,
                     grid.size.y, grid.size.z, nameOf(volume.scene.volume->type()), spacing.x, spacing.y, spacing.z,
                     grid.unit.empty() ? "units" : grid.unit, range.least, range.greatest);
}

void drawLight(TransferEditor& editor) {
  VolumeShading shading = editor.appearance()->shading;
  bool changed = ImGui::Checkbox("light", &shading.isOn);
  tip("Places are lit by the direction in which values change");
  if (shading.isOn) {
    changed |= slider("ambient", shading.ambient, 0, 1, "%.2f");
    changed |= slider("diffuse", shading.diffuse, 0, 1, "%.2f");
    changed |= slider("specular", shading.specular, 0, 1, "%.2f");
    changed |= slider("shininess", shading.shininess, 1, 200, "%.0f", ImGuiSliderFlags_Logarithmic);
  }
  if (changed) {
    editor.setShading(shading);
  }
}

void drawClipping(VolumeShown& shown) {
  constexpr std::array kNames{"kept along x", "kept along y", "kept along z"};
  for (size_t axis = 0; axis < kNames.size(); ++axis) {
    glm::vec2 percent = 100.0f * glm::vec2(shown.kept[axis]);
    if (ImGui::DragFloatRange2(kNames[axis], &percent.x, &percent.y, 0.5f, 0, 100, "%.0f %%", nullptr,
                               ImGuiSliderFlags_AlwaysClamp)) {
      shown.kept[axis] = glm::dvec2(percent) / 100.0;
    }
    tip("The part of the volume's box that shows: the rest is clipped. Drag, or Ctrl + click to type");
  }
}

}  // namespace

void VolumeForm::drawPoint(TransferEditor& editor) {
  if (!editor.chosen()) {
    ImGui::TextDisabled("no point is chosen");
    wantsPoint_ = false;
    return;
  }
  const size_t index = *editor.chosen();
  const TransferPoint point = editor.points()[index];
  if (wantsPoint_) {
    ImGui::SetKeyboardFocusHere();
    wantsPoint_ = false;
  }
  double value = point.value;
  double percent = 100 * point.opacity;
  constexpr auto kOnEnter = ImGuiInputTextFlags_EnterReturnsTrue;
  bool moved = ImGui::InputDouble("value", &value, 0, 0, "%.6g", kOnEnter);
  tip("Of the chosen point; Enter takes it over. It stays between its neighbours");
  moved |= ImGui::InputDouble("opacity, %", &percent, 0, 0, "%.4g", kOnEnter);
  tip("Of a slab that is as thick as the opacity length");
  if (moved) {
    editor.movePoint(index, value, percent / 100);
  }
  glm::vec3 encoded = encodedColor(point.color);
  if (ImGui::ColorEdit3("colour", &encoded.x, ImGuiColorEditFlags_NoInputs)) {
    editor.colorPoint(index, glm::dvec3(linearFromSrgb(encoded)));
  }
  tip("Opens a picker");
  ImGui::SameLine();
  if (ImGui::Button("Remove")) {
    editor.removePoint(index);
  }
}

void VolumeForm::drawFile(const PanelDrawing& drawing, float valueWidth) {
  TransferEditor& editor = *drawing.state.volume.transfer;
  ImGui::BeginDisabled(!editor.canUndo());
  if (ImGui::Button("Undo")) {
    editor.undo();
  }
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(!editor.canRedo());
  if (ImGui::Button("Redo")) {
    editor.redo();
  }
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button("Save (Ctrl + S)")) {
    drawing.wishes.actions.push_back(ViewerAction::kSaveTransfer);
  }
  ImGui::SetNextItemWidth(valueWidth);
  if (inputText("load function", file_) && !file_.empty()) {
    drawing.wishes.transfer = file_;
  }
  tip("A JSON file, as --transfer takes it; Enter loads it. A file may be dropped onto the window, too");
}

void VolumeForm::drawIso(const PanelDrawing& drawing) {
  ViewerState& state = drawing.state;
  const ValueAxis& values = state.volume.values;
  if (isoRevision_ != state.work.volumeRevision) {
    isoRevision_ = state.work.volumeRevision;
    iso_ = state.work.sceneOptions.iso.value_or(values.valueAt(0.5));
  }
  slider("surface at", iso_, values.least, values.greatest, "%.5g");
  const bool isLetGo = ImGui::IsItemDeactivatedAfterEdit();
  tip("The value whose surface the panes 1 to 6 show, as --iso");
  bool isOn = state.work.sceneOptions.iso.has_value();
  ImGui::SameLine();
  if (ImGui::Checkbox("##surface", &isOn) || (isLetGo && isOn)) {
    drawing.wishes.iso = isOn ? std::optional(iso_) : std::nullopt;
    drawing.wishes.changesIso = true;
  }
  tip("Whether there is such a surface");
}

void VolumeForm::draw(const PanelDrawing& drawing, float valueWidth) {
  ViewerState& state = drawing.state;
  const auto& scene = drawing.facts.data->scene;
  sectionTitle("Volume");
  if (!state.volume.transfer || !scene || !scene->volume) {
    noteText("nothing loaded yet");
    return;
  }
  TransferEditor& editor = *state.volume.transfer;
  noteText(sizeText(*scene->volume));
  ImGui::PushItemWidth(valueWidth);
  if (ImGui::BeginCombo("preset", "choose ...", ImGuiComboFlags_HeightLarge)) {
    for (const TransferPreset& preset : transferPresets()) {
      if (ImGui::Selectable(preset.name.c_str())) {
        drawing.wishes.transfer = preset.name;
      }
      tip(preset.summary.c_str());
    }
    ImGui::EndCombo();
  }
  drawPoint(editor);
  double length = editor.appearance()->transfer.opacityLength();
  const VolumeGrid& grid = scene->volume->scene.volume->grid();
  const std::string format = "%.4g " + literalFormat(grid.unit);
  const double mean = grid.meanSpacing();
  if (slider("opacity length", length, 0.01 * mean, 100 * mean, format.c_str(), ImGuiSliderFlags_Logarithmic)) {
    editor.setOpacityLength(length);
  }
  tip("Opacities are those of a slab that is so thick: shorter is denser");
  drawLight(editor);
  drawClipping(state.volume);
  drawIso(drawing);
  ImGui::PopItemWidth();
  drawFile(drawing, valueWidth);
  const bool isActive = ImGui::IsAnyItemActive();
  if (wasActive_ && !isActive) {
    editor.endStep();  // a drag of a slider is undone as a whole, and by itself
  }
  wasActive_ = isActive;
}

}  // namespace ocelli
