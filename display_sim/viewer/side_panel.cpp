#include "display_sim/viewer/side_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "display_sim/frames/display_profile.h"
#include "display_sim/viewer/camera_form.h"
#include "display_sim/viewer/effect_form.h"
#include "display_sim/viewer/gui_pieces.h"

namespace ocelli {
namespace {

constexpr float kValueWidth = 184;

/// Leaves room for the label where the panel is narrow.
float valueWidth(float scale) {
  constexpr float kMaxShare = 0.6f;
  return std::min(kValueWidth * scale, kMaxShare * ImGui::GetContentRegionAvail().x);
}

std::vector<CameraName> offeredCameras() {
  std::vector<CameraName> offered;
  for (const CameraName& name : cameraNames()) {
    if (cameraChoice(name.name).hasImages()) {
      offered.push_back(name);
    }
  }
  return offered;
}

std::string descriptionOf(const std::string& name) {
  for (const CameraName& each : cameraNames()) {
    if (name == each.name) {
      return each.description;
    }
  }
  return "from a file";
}

/// Milliseconds where they may be shown.
std::string timeText(const ViewerFacts& facts, double milliseconds) {
  return facts.showTimes ? fmt::format(" in {:.0f} ms", milliseconds) : std::string();
}

}  // namespace

void SidePanel::draw(const PanelDrawing& drawing) {
  if (drawing.layout.panel.width <= 0) {
    return;
  }
  if (wantsFocus_) {
    ImGui::SetNextWindowFocus();
    wantsFocus_ = false;
  }
  // Dense, so that all of it shows in a window of 800 lines; dark handles, so that the values on them can be read.
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(7 * drawing.scale, 2 * drawing.scale));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8 * drawing.scale, 4 * drawing.scale));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(12 * drawing.scale, 4 * drawing.scale));
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, kGuiAccentDeep.packed());
  ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, kGuiAccentDeep.packed());
  beginFixedWindow("panel", drawing.layout.panel, kGuiPanel);
  // Scrolls by itself where the window is low; flattened, so that keys get to what is in it.
  ImGui::BeginChild("contents", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  drawScene(drawing);
  if (drawing.state.volume.on) {
    volumeForm_.draw(drawing, valueWidth(drawing.scale));
  }
  drawCamera(drawing);
  drawDisplay(drawing);
  if (isOffered(drawing.state, Pane::kEffect)) {
    drawEffectForm(drawing, valueWidth(drawing.scale));
  }
  drawShown(drawing);
  ImGui::EndChild();
  ImGui::End();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar(3);
}

void SidePanel::drawScene(const PanelDrawing& drawing) {
  const ViewerFacts& facts = drawing.facts;
  sectionTitle("Scene");
  if (knownSource_ != drawing.state.work.source) {
    knownSource_ = source_ = drawing.state.work.source;
  }
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (inputText("##source", source_) && !source_.empty()) {
    drawing.wishes.open = source_;
  }
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("A file, or builtin:NAME[,key=value...]; Enter opens it");
  }
  const auto& scene = facts.data->scene;
  if (!scene) {
    noteText("nothing loaded yet");
  } else if (hasMesh(drawing.state)) {
    noteText(grouped(scene->mesh.triangles.size()) + " triangles");
  }
}

void SidePanel::drawCamera(const PanelDrawing& drawing) {
  ViewerState& state = drawing.state;
  const ViewerFacts& facts = drawing.facts;
  sectionTitle("Camera");
  ImGui::SetNextItemWidth(-FLT_MIN);
  const std::string& rays = state.volume.rays;
  if (ImGui::BeginCombo("##camera", (rays.empty() ? state.work.camera.name : rays).c_str(),
                        ImGuiComboFlags_HeightLarge)) {
    for (const CameraName& camera : offeredCameras()) {
      if (ImGui::Selectable(camera.name, rays.empty() && state.work.camera.name == camera.name)) {
        chooseCamera(state, camera.name);
      }
      if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", camera.description);
      }
    }
    ImGui::EndCombo();
  }
  noteText(rays.empty() ? descriptionOf(state.work.camera.name) : "of the volume alone");
  if (drawCameraForm(state.work.camera, valueWidth(drawing.scale))) {
    cameraChanged(state);
  }
  if (hasLenses(state)) {
    lensForm_.draw(drawing, valueWidth(drawing.scale));
  }
  drawImageSize(drawing);
  if (ImGui::Button("Reference view to your eye")) {
    drawing.wishes.actions.push_back(ViewerAction::kReferenceToEye);
  }
  if (const auto& camera = facts.data->camera) {
    const Representation& made = camera->representation;
    noteText(grouped(made.sampleCount()) + " samples" + timeText(facts, camera->times.buildMilliseconds) + ", " +
             grouped(made.mesh.triangles.size()) + " triangles" + timeText(facts, camera->times.meshMilliseconds));
  }
}

void SidePanel::drawImageSize(const PanelDrawing& drawing) {
  ViewerState& state = drawing.state;
  const glm::ivec2 current(state.work.width, state.work.height);
  if (knownSize_ != current) {
    knownSize_ = size_ = current;
  }
  ImGui::SetNextItemWidth(valueWidth(drawing.scale));
  ImGui::InputInt2("image size", &size_.x);
  if (ImGui::IsItemDeactivatedAfterEdit()) {
    chooseImageSize(state, size_.x, size_.y);
    knownSize_ = size_ = {state.work.width, state.work.height};
  }
}

void SidePanel::drawDisplay(const PanelDrawing& drawing) {
  DisplayShown& display = drawing.state.display;
  sectionTitle("Display");
  ImGui::PushItemWidth(valueWidth(drawing.scale));
  if (ImGui::BeginCombo("profile", drawing.state.work.profile.c_str())) {
    for (const std::string& name : builtinProfileNames()) {
      if (ImGui::Selectable(name.c_str(), drawing.state.work.profile == name)) {
        chooseProfile(drawing.state, name);
      }
    }
    ImGui::EndCombo();
  }
  int sliced = drawing.state.work.sliceScene ? 1 : 0;
  if (hasMesh(drawing.state) && ImGui::Combo("slices of", &sliced, "camera's mesh\0scene itself\0")) {
    drawing.wishes.actions.push_back(ViewerAction::kToggleSliced);
  }
  auto exponent = static_cast<float>(std::log2(display.speed));
  const std::string speed = speedText(display.speed) + " of real speed";
  if (ImGui::SliderFloat("speed", &exponent, -14, 2, speed.c_str(), ImGuiSliderFlags_AlwaysClamp)) {
    display.speed = std::exp2(std::round(exponent));
  }
  auto persistence = static_cast<float>(display.persistenceSeconds * 1000);
  if (ImGui::SliderFloat("persistence", &persistence, 1, 5000, "%.0f ms",
                         ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic)) {
    display.persistenceSeconds = persistence / 1000.0;
  }
  auto gain = static_cast<float>(display.gain);
  if (ImGui::SliderFloat("gain", &gain, 0.1f, 10, "%.2f x",
                         ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic)) {
    display.gain = gain;
  }
  ImGui::PopItemWidth();
  if (ImGui::Button(display.running ? "Stop" : "Run", {60 * drawing.scale, 0})) {
    drawing.wishes.actions.push_back(ViewerAction::kRunOrStop);
  }
  ImGui::SameLine();
  ImGui::Checkbox("observer is your eye", &display.followsEye);
  if (const auto& volume = drawing.facts.data->volume) {
    noteText(grouped(volume->litVoxels) + " lit voxels" + timeText(drawing.facts, volume->milliseconds));
  }
}

void SidePanel::drawShown(const PanelDrawing& drawing) {
  ViewerState& state = drawing.state;
  if (!hasMesh(state)) {
    drawButtons(drawing);
    return;
  }
  sectionTitle("Panes show");
  SceneShown& scene = state.scene;
  const float column = 104 * drawing.scale;
  ImGui::Checkbox("rays", &scene.rays);
  ImGui::SameLine(column);
  ImGui::Checkbox("straight", &scene.straightRays);
  ImGui::SameLine(2 * column);
  ImGui::Checkbox("cell", &scene.cell);
  ImGui::Checkbox("frustum", &scene.frustum);
  ImGui::SameLine(column);
  ImGui::Checkbox("samples", &scene.samples);
  ImGui::SameLine(2 * column);
  bool effect = state.effect.on;
  if (ImGui::Checkbox("effect", &effect)) {
    drawing.wishes.actions.push_back(ViewerAction::kToggleEffect);
  }
  ImGui::PushItemWidth(valueWidth(drawing.scale));
  glm::ivec2 grid(scene.rayColumns, scene.rayRows);
  if (ImGui::SliderInt2("ray grid", &grid.x, 1, kMaxRayRows, "%d", ImGuiSliderFlags_AlwaysClamp)) {
    scene.rayColumns = grid.x;
    scene.rayRows = grid.y;
  }
  comboOf("image", state.reference.quantity, 3);
  comboOf("eye sees", state.reconstruction.content, 5);
  ImGui::PopItemWidth();
  drawButtons(drawing);
}

void SidePanel::drawButtons(const PanelDrawing& drawing) {
  if (ImGui::Button("Help (H)")) {
    drawing.wishes.actions.push_back(ViewerAction::kHelp);
  }
  ImGui::SameLine();
  if (ImGui::Button("Save image (S)")) {
    drawing.wishes.actions.push_back(ViewerAction::kScreenshot);
  }
  ImGui::SameLine();
  if (ImGui::Button("View (J)")) {
    drawing.wishes.actions.push_back(ViewerAction::kSaveView);
  }
}

}  // namespace ocelli
