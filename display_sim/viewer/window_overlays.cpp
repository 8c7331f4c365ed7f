#include "display_sim/viewer/window_overlays.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string_view>

#include "display_sim/viewer/gui_pieces.h"
#include "display_sim/viewer/lens_keys.h"
#include "display_sim/viewer/transfer_keys.h"
#include "display_sim/viewer/transfer_pointer.h"

namespace ocelli {
namespace {

/// As many as fit into `room`.
std::string figures(const ViewerFacts& facts, float room) {
  std::string text;
  const auto add = [&](const std::string& more) {
    const std::string longer = text + (text.empty() ? "" : "   ") + more;
    if (ImGui::CalcTextSize(longer.c_str()).x <= room) {
      text = longer;
    }
  };
  if (facts.frameMilliseconds > 0) {
    add(fmt::format("{:.1f} ms a frame", facts.frameMilliseconds));
  }
  if (facts.data->scene && !facts.data->scene->mesh.triangles.empty()) {
    add("scene " + grouped(facts.data->scene->mesh.triangles.size()) + " triangles");
  }
  if (facts.data->scene && facts.data->scene->volume) {
    add(grouped(facts.data->scene->volume->scene.volume->grid().voxelCount()) + " voxels");
  }
  if (const auto& camera = facts.data->camera) {
    add(camera->choice.name + " " + grouped(camera->representation.mesh.triangles.size()) + " triangles, " +
        grouped(camera->representation.sampleCount()) + " samples");
  }
  if (facts.missing) {
    add(fmt::format("{:.2f} % missing", 100 * facts.missing->strictRatio()));
  }
  return text;
}

void helpRow(std::string_view keys, std::string_view text) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, kOkabeItoYellow.packed());
  ImGui::TextUnformatted(keys.data(), keys.data() + keys.size());
  ImGui::PopStyleColor();
  ImGui::TableNextColumn();
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
}

void beginHelpGroup(const char* title, float keyWidth) {
  sectionTitle(title);
  ImGui::BeginTable(title, 2);
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, keyWidth);
  ImGui::TableSetupColumn("text", ImGuiTableColumnFlags_WidthStretch);
}

void drawPointerHelp(float keyWidth) {
  beginHelpGroup("Pointer", keyWidth);
  for (const PointerBinding& binding : pointerBindings()) {
    helpRow(binding.what, binding.text);
  }
  ImGui::EndTable();
}

void drawKeyHelp(const std::string& group, float keyWidth) {
  beginHelpGroup(group.c_str(), keyWidth);
  for (const KeyBinding& binding : keyBindings()) {
    if (binding.group == group && *binding.keys != '\0') {
      helpRow(binding.keys, binding.text);
    }
  }
  ImGui::EndTable();
}

void drawPaneHelp(const char* title, const std::vector<PointerBinding>& pointer, const std::vector<PaneKey>& keys,
                  float keyWidth) {
  beginHelpGroup(title, keyWidth);
  for (const PointerBinding& binding : pointer) {
    helpRow(binding.what, binding.text);
  }
  for (const PaneKey& each : keys) {
    if (*each.keys != '\0') {
      helpRow(each.keys, each.text);
    }
  }
  ImGui::EndTable();
}

std::vector<std::string> helpGroups() {
  std::vector<std::string> groups;
  for (const KeyBinding& binding : keyBindings()) {
    if (groups.empty() || groups.back() != binding.group) {
      groups.emplace_back(binding.group);
    }
  }
  return groups;
}

}  // namespace

void drawStatusBar(const PanelDrawing& drawing) {
  const ViewerFacts& facts = drawing.facts;
  const WindowRect& bar = drawing.layout.status;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(12 * drawing.scale, 0));
  beginFixedWindow("status", bar, kGuiBackground, ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  const float y = (bar.height - ImGui::GetTextLineHeight()) / 2;
  ImGui::SetCursorPosY(y);
  if (facts.work.busy) {
    ImGui::PushStyleColor(ImGuiCol_Text, kOkabeItoOrange.packed());
    ImGui::TextUnformatted(
        fmt::format("{} {:.0f} %", facts.work.stage.empty() ? "working" : facts.work.stage, 100 * facts.work.fraction)
            .c_str());
    ImGui::PopStyleColor();
    ImGui::SameLine(0, 16 * drawing.scale);
  }
  ImGui::TextUnformatted(figures(facts, bar.width - ImGui::GetCursorPosX() - 12 * drawing.scale).c_str());
  ImGui::SameLine(0, 24 * drawing.scale);
  const float left = ImGui::GetCursorPosX();
  const float right = bar.width - ImGui::CalcTextSize(facts.renderer.c_str()).x - 12 * drawing.scale;
  if (right >= left) {
    ImGui::SetCursorPos({right, y});
    ImGui::PushStyleColor(ImGuiCol_Text, kGuiTextDim.packed());
    ImGui::TextUnformatted(facts.renderer.c_str());
    ImGui::PopStyleColor();
  }
  ImGui::End();
}

/// What the pointer does, and groups of keys, in two columns; in one where the window is narrow.
void drawHelp(const PanelDrawing& drawing) {
  if (!drawing.state.help) {
    return;
  }
  const float scale = drawing.scale;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const ImVec2 size(std::min(960 * scale, window.x - 16 * scale), std::min(680 * scale, window.y - 16 * scale));
  ImGui::SetNextWindowPos({(window.x - size.x) / 2, (window.y - size.y) / 2});
  ImGui::SetNextWindowSize(size);
  ImGui::Begin("help", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::BeginChild("help contents");
  const float keyWidth = 126 * scale;
  const int columns = size.x >= 840 * scale ? 2 : 1;
  if (ImGui::BeginTable("columns", columns, ImGuiTableFlags_SizingStretchSame)) {
    const std::vector<std::string> groups = helpGroups();
    const size_t inFirst = groups.size() / 2;
    ImGui::TableNextColumn();
    drawPointerHelp(keyWidth);
    if (hasLenses(drawing.state)) {
      drawPaneHelp("In the pane of lenses (6), before all else", lensPointerBindings(), lensKeys(), keyWidth);
    }
    if (drawing.state.volume.on) {
      drawPaneHelp("In the pane of the transfer function (8), before all else", transferPointerBindings(),
                   transferKeys(), keyWidth);
    }
    for (size_t i = 0; i < inFirst; ++i) {
      drawKeyHelp(groups[i], keyWidth);
    }
    ImGui::TableNextColumn();
    for (size_t i = inFirst; i < groups.size(); ++i) {
      drawKeyHelp(groups[i], keyWidth);
    }
    ImGui::EndTable();
  }
  ImGui::EndChild();
  ImGui::End();
}

void drawMessage(const PanelDrawing& drawing) {
  const ViewerFacts& facts = drawing.facts;
  if (facts.message.empty()) {
    return;
  }
  const float scale = drawing.scale;
  const WindowRect& panel = drawing.layout.panel;
  const float left = panel.right();
  const float room = drawing.layout.status.width - left;
  const float width = std::min(640 * scale, room - 24 * scale);
  ImGui::SetNextWindowPos({left + room / 2, drawing.layout.status.y - 12 * scale}, ImGuiCond_Always, {0.5f, 1.0f});
  ImGui::SetNextWindowSize({std::max(width, 1.0f), 0});
  ImGui::PushStyleColor(ImGuiCol_Border, (facts.messageIsError ? kOkabeItoVermillion : kGuiAccent).packed());
  ImGui::Begin("message", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleColor();
  if (facts.messageIsError) {
    ImGui::PushStyleColor(ImGuiCol_Text, kOkabeItoOrange.packed());
    ImGui::TextUnformatted("That did not work");
    ImGui::PopStyleColor();
  }
  ImGui::TextWrapped("%s", facts.message.c_str());
  if (facts.messageIsError && ImGui::Button("Close (Escape)")) {
    drawing.wishes.dismissMessage = true;
  }
  ImGui::End();
}

}  // namespace ocelli
