#include "oc_core/feeds_window/feed_marks.h"

#include <imgui.h>

#include <array>

#include "oc_core/window/gui_style.h"

namespace ocelli {
namespace {

constexpr float kMarkRadius = 5;  ///< screen coordinates at 96 dots an inch, here and below
constexpr float kMarkRoom = 20;
constexpr float kBetween = 24;
constexpr float kPlateRim = 5;

constexpr std::array<FeedStateMeaning, 6> kMeanings{{
    {FeedState::kLive, "frames come in"},
    {FeedState::kLate, "LATE: its frame is overdue"},
    {FeedState::kFrozen, "FROZEN: frames come in that are all the same"},
    {FeedState::kCovered, "COVERED: what it shows is not the place"},
    {FeedState::kEnded, "ENDED: it was read to its end"},
    {FeedState::kLost, "LOST: it broke off; a live one is tried again"},
}};

GuiColor colorOf(const FeedLabel& label) {
  return label.isGood() ? kGuiText : kOkabeItoYellow;
}

}  // namespace

std::span<const FeedStateMeaning> feedStateMeanings() {
  return kMeanings;
}

void drawFeedMark(ImDrawList& list, const glm::vec2& at, FeedState state, float scale) {
  const float r = kMarkRadius * scale;
  const ImVec2 c(at.x + r + scale, at.y + ImGui::GetTextLineHeight() / 2);
  switch (state) {
    case FeedState::kLive:
      list.AddCircleFilled(c, r, kOkabeItoBluishGreen.packed());
      break;
    case FeedState::kLate:
      list.AddTriangleFilled({c.x, c.y - r}, {c.x + r, c.y + r}, {c.x - r, c.y + r}, kOkabeItoOrange.packed());
      break;
    case FeedState::kFrozen:
      list.AddRectFilled({c.x - r, c.y - r}, {c.x + r, c.y + r}, kOkabeItoSkyBlue.packed());
      break;
    case FeedState::kCovered:
      list.AddCircleFilled(c, r, kOkabeItoReddishPurple.packed());
      list.AddLine({c.x - r, c.y}, {c.x + r, c.y}, kGuiPanel.packed(), 2 * scale);
      break;
    case FeedState::kEnded:
      list.AddCircle(c, r, kGuiTextDim.packed(), 0, 2 * scale);
      break;
    case FeedState::kLost:
      list.AddLine({c.x - r, c.y - r}, {c.x + r, c.y + r}, kOkabeItoVermillion.packed(), 3 * scale);
      list.AddLine({c.x - r, c.y + r}, {c.x + r, c.y - r}, kOkabeItoVermillion.packed(), 3 * scale);
      break;
  }
}

void drawFeedState(ImDrawList& list, const glm::vec2& at, const std::string& name, const FeedLabel& label,
                   float scale) {
  drawFeedMark(list, at, label.state, scale);
  list.AddText({at.x + kMarkRoom * scale, at.y}, colorOf(label).packed(), feedLabelText(name, label).c_str());
}

float feedStateWidth(const std::string& name, const FeedLabel& label, float scale) {
  return (kMarkRoom + kBetween) * scale + ImGui::CalcTextSize(feedLabelText(name, label).c_str()).x;
}

void drawFeedPlate(ImDrawList& list, const glm::vec2& at, const std::string& name, const FeedLabel& label,
                   float scale) {
  const float rim = kPlateRim * scale;
  const float width = feedStateWidth(name, label, scale) - kBetween * scale;
  list.AddRectFilled({at.x, at.y}, {at.x + width + 2 * rim, at.y + ImGui::GetTextLineHeight() + 2 * rim},
                     kGuiPanel.packed(215), 4 * scale);
  drawFeedState(list, at + rim, name, label, scale);
}

}  // namespace ocelli
