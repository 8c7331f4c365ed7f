// The help: one screen, made from the tables of keys.
#include <imgui.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "oc_core/explore_window/explore_colors.h"
#include "oc_core/explore_window/explore_overlays.h"

namespace ocelli {
namespace {

struct HelpLine {
  std::string_view keys;
  std::string_view meaning;
  std::string_view pad;
};

std::vector<std::string_view> exploreHelpGroups() {
  std::vector<std::string_view> groups;
  for (const ExploreKeyAction& row : exploreKeyActions()) {
    if (std::ranges::find(groups, std::string_view(row.group)) == groups.end()) {
      groups.emplace_back(row.group);
    }
  }
  return groups;
}

std::vector<HelpLine> linesOfGroup(std::string_view group) {
  std::vector<HelpLine> lines;
  const auto add = [&](const auto& row) {
    if (row.group == group && *row.keys != '\0') {
      lines.push_back({row.keys, row.meaning, row.pad});
    }
  };
  std::ranges::for_each(exploreHeldKeys(), add);
  std::ranges::for_each(exploreKeyActions(), add);
  return lines;
}

void textOf(std::string_view text, GuiColor color) {
  ImGui::PushStyleColor(ImGuiCol_Text, color.packed());
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void drawLines(std::string_view title, const std::vector<HelpLine>& lines, float scale) {
  textOf(title, kGuiAccent);
  ImGui::Separator();
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(4 * scale, 1 * scale));
  if (ImGui::BeginTable(std::string(title).c_str(), 3)) {
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, 136 * scale);
    ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("gamepad", ImGuiTableColumnFlags_WidthFixed, 96 * scale);
    for (const HelpLine& line : lines) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      textOf(line.keys, kOkabeItoYellow);
      ImGui::TableNextColumn();
      textOf(line.meaning, kGuiText);
      ImGui::TableNextColumn();
      textOf(line.pad, kGuiTextDim);
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
  ImGui::Dummy({0, 4 * scale});
}

/// In two columns, in place of all else: they are what keys do now.
void drawPaneLines(const ExploreOverlayFrame& frame) {
  if (!ImGui::BeginTable("explore pane help", 2, ImGuiTableFlags_SizingStretchSame)) {
    return;
  }
  const size_t half = (frame.paneHelp.size() + 1) / 2;
  std::vector<HelpLine> lines;
  for (size_t i = 0; i < frame.paneHelp.size(); ++i) {
    lines.push_back({frame.paneHelp[i].keys, frame.paneHelp[i].meaning, ""});
    if (i + 1 == half || i + 1 == frame.paneHelp.size()) {
      ImGui::TableNextColumn();
      drawLines(i + 1 == half ? "Keys of this pane" : "More of them; F6 goes to the next pane", lines, frame.scale);
      lines.clear();
    }
  }
  ImGui::EndTable();
}

void drawCameraLines(const ExploreOverlayFrame& frame) {
  const WindowPicture* picture = frame.target.picture;
  if (picture == nullptr) {
    return;
  }
  std::vector<std::string> names;
  for (size_t i = 0; i < picture->choices.size(); ++i) {
    names.push_back(std::to_string(i + 1) + "  " + picture->choices[i].name);
  }
  std::vector<HelpLine> lines;
  for (size_t i = 0; i < names.size(); ++i) {
    lines.push_back({names[i], picture->choices[i].meaning, ""});
  }
  drawLines("The cameras", lines, frame.scale);
}

}  // namespace

void drawExploreHelp(const ExploreOverlayFrame& frame) {
  if (!frame.target.state.help) {
    return;
  }
  const float scale = frame.scale;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float width = std::min(1120 * scale, window.x - 16 * scale);
  ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, std::max(window.y - 16 * scale, 1.0f)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, kGuiPanel.packed(250));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {20 * scale, 14 * scale});
  ImGui::Begin("explore help", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  textOf(
      "Walk through the scene. The camera that you choose bends its rays, so that you see around corners and "
      "through doors before you are there.",
      kGuiText);
  ImGui::Dummy({0, 4 * scale});
  if (!frame.paneHelp.empty()) {
    drawPaneLines(frame);
    ImGui::End();
    return;
  }
  const std::vector<std::string_view> groups = exploreHelpGroups();
  const int columns = width >= 900 * scale ? 2 : 1;
  if (ImGui::BeginTable("explore help columns", columns, ImGuiTableFlags_SizingStretchSame)) {
    ImGui::TableNextColumn();
    for (size_t i = 0; i < groups.size(); ++i) {
      if (i == groups.size() / 2) {
        ImGui::TableNextColumn();
      }
      drawLines(groups[i], linesOfGroup(groups[i]), scale);
      if (i == 0) {
        std::vector<HelpLine> pointer;
        for (const ExplorePointerRow& row : explorePointerRows()) {
          pointer.push_back({row.what, row.meaning, ""});
        }
        drawLines("Pointer", pointer, scale);
      }
    }
    drawCameraLines(frame);
    ImGui::EndTable();
  }
  ImGui::End();
}

}  // namespace ocelli
