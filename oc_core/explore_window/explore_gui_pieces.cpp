#include "oc_core/explore_window/explore_gui_pieces.h"

#include <imgui.h>

#include <algorithm>

namespace ocelli {

void beginExploreArea(const char* name, const ExplorePaneRect& rect, GuiColor background, uint8_t opacity,
                      bool takesPointer) {
  ImGui::SetNextWindowPos({rect.x, rect.y});
  ImGui::SetNextWindowSize({rect.width, rect.height});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, background.packed(opacity));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav |
                   (takesPointer ? 0 : ImGuiWindowFlags_NoMouseInputs));
  ImGui::PopStyleVar(3);
  ImGui::PopStyleColor();
}

void drawExploreOutline(ImDrawList& list, std::span<const glm::vec2> points, GuiColor color, float scale) {
  if (points.size() < 2) {
    return;
  }
  list.PathClear();
  for (const glm::vec2& point : points) {
    list.PathLineTo({point.x, point.y});
  }
  list.PathStroke(color.packed(70), ImDrawFlags_Closed, 7 * scale);
  for (const glm::vec2& point : points) {
    list.PathLineTo({point.x, point.y});
  }
  list.PathStroke(color.packed(), ImDrawFlags_Closed, 2 * scale);
}

void drawExploreBadge(ImDrawList& list, const glm::vec2& at, const std::string& text, GuiColor color, float scale) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float across = std::max(size.x + 8 * scale, size.y);
  const ImVec2 corner(at.x - across / 2, at.y - size.y / 2);
  list.AddRectFilled(corner, {corner.x + across, corner.y + size.y}, color.packed(230), 4 * scale);
  list.AddText({at.x - size.x / 2, corner.y}, kGuiBackground.packed(), text.c_str());
}

std::string fittedExploreText(std::string_view text, float width) {
  const auto widthOf = [](std::string_view part) {
    return ImGui::CalcTextSize(part.data(), part.data() + part.size()).x;
  };
  if (widthOf(text) <= width) {
    return std::string(text);
  }
  const std::string end = "…";
  const float left = width - widthOf(end);
  // Only whole characters of UTF-8.
  const auto isBorder = [&](size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0U) != 0x80U; };
  size_t size = text.size() - 1;
  while (size > 0 && (!isBorder(size) || widthOf(text.substr(0, size)) > left)) {
    --size;
  }
  return std::string(text.substr(0, size)) + end;
}

}  // namespace ocelli
