#include "display_sim/viewer/gui_pieces.h"

#include <imgui.h>

#include <array>

#include "oc_core/image/color.h"

namespace ocelli {

void beginFixedWindow(const char* name, const WindowRect& rect, GuiColor background, int moreFlags) {
  ImGui::SetNextWindowPos({rect.x, rect.y});
  ImGui::SetNextWindowSize({rect.width, rect.height});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, background.packed());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus | moreFlags);
  ImGui::PopStyleVar(3);
  ImGui::PopStyleColor();
}

bool comboOfNames(const char* label, int& index, int count, const std::function<std::string_view(int)>& nameAt) {
  bool changed = false;
  if (ImGui::BeginCombo(label, std::string(nameAt(index)).c_str())) {
    for (int i = 0; i < count; ++i) {
      if (ImGui::Selectable(std::string(nameAt(i)).c_str(), i == index)) {
        changed = i != index;
        index = i;
      }
    }
    ImGui::EndCombo();
  }
  return changed;
}

bool inputText(const char* label, std::string& text) {
  std::array<char, 1024> buffer{};  // ImGui edits text in place
  text.copy(buffer.data(), buffer.size() - 1);
  const bool entered = ImGui::InputText(label, buffer.data(), buffer.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  text = buffer.data();
  return entered;
}

glm::vec3 encodedColor(const glm::dvec3& linear) {
  const glm::vec3 color(linear);
  return {srgbFromLinear(color.r), srgbFromLinear(color.g), srgbFromLinear(color.b)};
}

void noteText(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, kGuiTextDim.packed());
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
}

void sectionTitle(const char* text) {
  ImGui::Dummy({0, ImGui::GetStyle().ItemSpacing.y / 2});
  ImGui::PushStyleColor(ImGuiCol_Text, kGuiAccent.packed());
  ImGui::TextUnformatted(text);
  ImGui::PopStyleColor();
  ImGui::Separator();
}

}  // namespace ocelli
