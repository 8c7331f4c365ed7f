// The options of the constructor that is chosen, as a form over the view: sliders for the mouse, and keys.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "oc_core/explore_window/explore_colors.h"
#include "oc_core/explore_window/explore_gui_pieces.h"
#include "oc_core/explore_window/explore_overlays.h"

namespace ocelli {
namespace {

constexpr int kMaxFormDigits = 3;

/// As many digits as steps need.
std::string formValueText(const WindowField& field) {
  const auto index = static_cast<size_t>(std::max(field.value, 0.0));
  if (!field.names.empty()) {
    return field.names[std::min(index, field.names.size() - 1)];
  }
  // Of the step: 0.025 has three. A value between steps has no more.
  int digits = 0;
  for (double step = field.step; digits < kMaxFormDigits && std::abs(step - std::round(step)) > 1e-6; step *= 10) {
    ++digits;
  }
  return fmt::format("{:.{}f}{}{}", field.value, digits, field.unit.empty() ? "" : " ", field.unit);
}

void tellFormValue(const ExploreOverlayFrame& frame, const std::string& name, double value) {
  frame.target.work.tell([name, value](ExploreWindowModel& model) {
    model.setField(name, value);
    return std::string();
  });
}

void drawFormRow(const ExploreOverlayFrame& frame, const WindowField& field, bool isChosen, float width) {
  ImGui::PushStyleColor(ImGuiCol_Text, isChosen ? kGuiAccent.packed() : kGuiText.packed());
  ImGui::TextUnformatted(field.label.c_str());
  ImGui::PopStyleColor();
  const std::string text = formValueText(field);
  ImGui::SameLine(std::max(width - ImGui::CalcTextSize(text.c_str()).x, 0.0f));
  ImGui::TextUnformatted(text.c_str());
  ImGui::SetNextItemWidth(width);
  const std::string id = "##" + field.name;
  auto value = static_cast<float>(field.value);
  if (ImGui::SliderFloat(id.c_str(), &value, static_cast<float>(field.lower), static_cast<float>(field.upper), "",
                         ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput)) {
    const double steps = std::round((static_cast<double>(value) - field.lower) / field.step);
    tellFormValue(frame, field.name, std::clamp(field.lower + steps * field.step, field.lower, field.upper));
  }
  if (isChosen) {
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRect(from, to, kGuiAccent.packed(), ImGui::GetStyle().FrameRounding, 0,
                                        1.5f * frame.scale);
    ImGui::PushStyleColor(ImGuiCol_Text, kGuiTextDim.packed());
    ImGui::PushTextWrapPos(width);
    ImGui::TextUnformatted(field.meaning.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
  }
  ImGui::Dummy({0, 2 * frame.scale});
}

}  // namespace

void drawExploreForm(const ExploreOverlayFrame& frame) {
  ExploreWindowState& state = frame.target.state;
  const WindowPicture* picture = frame.target.picture;
  if (!state.form || picture == nullptr || picture->chosen >= picture->choices.size()) {
    return;
  }
  const float scale = frame.scale;
  const ExplorePaneRect& view = frame.layout.panes.front().rect;
  const float width = std::min(300 * scale, view.width - 24 * scale);
  ImGui::SetNextWindowPos({view.x + 12 * scale, view.y + 12 * scale});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, std::max(view.height - 24 * scale, 1.0f)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, kGuiPanel.packed(240));
  ImGui::Begin("explore options", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PopStyleColor();
  const float inner = width - 2 * ImGui::GetStyle().WindowPadding.x;
  ImGui::TextUnformatted(fmt::format("Options: {}", picture->choices[picture->chosen].name).c_str());
  ImGui::PushStyleColor(ImGuiCol_Text, kGuiTextDim.packed());
  ImGui::TextUnformatted(picture->fields.empty() ? "This camera has none." : "J: next    - +: change    O: close");
  ImGui::PopStyleColor();
  ImGui::Separator();
  for (size_t i = 0; i < picture->fields.size(); ++i) {
    drawFormRow(frame, picture->fields[i], i == state.formRow, inner);
  }
  ImGui::End();
}

}  // namespace ocelli
