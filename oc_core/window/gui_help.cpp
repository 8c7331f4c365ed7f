#include "oc_core/window/gui_help.h"

#include <imgui.h>

#include "oc_core/window/gui_style.h"

namespace ocelli {

GuiHelp::GuiHelp(const glm::ivec2& window, float scale, float width, float keysWidth, const char* title)
    : keysWidth_(keysWidth * scale) {
  ImGui::SetNextWindowPos({static_cast<float>(window.x) / 2, static_cast<float>(window.y) / 2}, 0, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({width * scale, 0});
  ImGui::SetNextWindowBgAlpha(0.95f);
  ImGui::Begin("help", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
  ImGui::TextUnformatted(title);
  ImGui::Separator();
}

GuiHelp::~GuiHelp() {
  ImGui::End();
}

void GuiHelp::beginRows() const {
  ImGui::BeginTable("keys", 2);
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, keysWidth_);
  ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch);
}

void GuiHelp::addRow(const char* shown, const char* meaning) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, kOkabeItoYellow.packed());
  ImGui::TextUnformatted(shown);
  ImGui::PopStyleColor();
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", meaning);
}

void GuiHelp::endRows() {
  ImGui::EndTable();
}

}  // namespace ocelli
