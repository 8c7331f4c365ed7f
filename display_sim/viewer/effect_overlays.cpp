#include "display_sim/viewer/effect_overlays.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "display_sim/viewer/effect_choice.h"
#include "display_sim/viewer/gui_pieces.h"

namespace ocelli {
namespace {

using EffectContent = EffectShown::Content;

std::string differenceText(const EffectDifference& difference) {
  const double all = static_cast<double>(std::max<size_t>(difference.pixels, 1));
  return fmt::format("{:.2f} % of pixels differ, {:.2f} % clearly (by more than {} of 255), PSNR {}",
                     100 * static_cast<double>(difference.different) / all, 100 * difference.clearShare(),
                     kClearDifference,
                     std::isfinite(difference.psnrDecibels) ? fmt::format("{:.1f} dB", difference.psnrDecibels)
                                                            : std::string("infinite"));
}

std::string workText(const EffectStatus& status) {
  return status.stage.empty() ? "drawing ..." : fmt::format("{} {:.0f} %", status.stage, 100 * status.fraction);
}

/// "by cell", "traced", "traced in 12 ms".
std::string pictureText(const std::string& name, const EffectImage& image, bool showTimes) {
  return showTimes && !image.image.empty() ? fmt::format("{} in {:.0f} ms", name, image.milliseconds) : name;
}

std::string shownText(const EffectPicture& picture, EffectContent content, bool showTimes) {
  const std::string byWay = pictureText("by " + picture.wanted.way, picture.byWay, showTimes);
  const std::string traced = pictureText("traced", picture.traced, showTimes);
  std::string text = content == EffectContent::kByWay       ? byWay
                     : content == EffectContent::kByTracing ? traced
                                                            : byWay + " against " + traced;
  if (!picture.isWhole) {
    return text + " (small while it moves)";
  }
  if (picture.difference && content != EffectContent::kByTracing) {
    text += ": " + differenceText(*picture.difference);
  }
  return text;
}

}  // namespace

std::string effectDetail(const ViewerState& state, const EffectStatus& status) {
  if (!status.picture) {
    return state.effect.effect;
  }
  const EffectWanted& of = status.picture->wanted;
  const std::string way = state.effect.content == EffectContent::kByTracing ? "traced" : "by " + of.way;
  return fmt::format("{}, {}, {} x {}", of.effect, way, of.size.x, of.size.y);
}

std::string effectNote(const ViewerState& state, const EffectStatus& status, bool showTimes) {
  if (!status.error.empty()) {
    return status.error;
  }
  const EffectContent content = state.effect.content;
  if (!status.picture || status.picture->shown(content) == nullptr) {
    return status.busy ? "in the making: " + workText(status) : "nothing to show";
  }
  std::string text = shownText(*status.picture, content, showTimes);
  const bool isMaking = status.busy && !status.stage.empty();
  return isMaking ? text + "\n" + workText(status) : text;
}

float drawEffectSwitch(const PanelDrawing& drawing, const WindowRect& image) {
  ViewerState& state = drawing.state;
  const float margin = 8 * drawing.scale;
  const std::string way = chosenWay(state);
  if (way.empty()) {
    return 0;
  }
  const std::array<std::pair<EffectContent, std::string>, 3> choices{{{EffectContent::kByWay, "By " + way},
                                                                      {EffectContent::kByTracing, "Traced"},
                                                                      {EffectContent::kDifference, "Difference"}}};
  const ImGuiStyle& style = ImGui::GetStyle();
  float width = 2 * style.ItemSpacing.x;
  for (const auto& [content, text] : choices) {
    width += ImGui::CalcTextSize(text.c_str()).x + 2 * style.FramePadding.x;
  }
  const float height = ImGui::GetFrameHeight();
  if (width > image.width - 2 * margin || height > image.height / 3) {
    return 0;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  beginFixedWindow("effect switch", {image.right() - margin - width, image.bottom() - margin - height, width, height},
                   kGuiBackground, ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollWithMouse);
  for (const auto& [content, text] : choices) {
    const bool isShown = content == state.effect.content;
    ImGui::PushStyleColor(ImGuiCol_Button, (isShown ? kGuiAccentDeep : kGuiField).packed());
    if (ImGui::Button((text + "##" + std::string(nameOf(content))).c_str())) {
      state.effect.content = content;
    }
    ImGui::PopStyleColor();
    ImGui::SameLine();
  }
  ImGui::End();
  ImGui::PopStyleVar();
  return height + margin;
}

}  // namespace ocelli
