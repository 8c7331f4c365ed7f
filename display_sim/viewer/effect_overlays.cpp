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

std::string workText(const ViewerState& state, const EffectStatus& status) {
  return status.stage.empty()
             ? "drawing ..."
             : fmt::format("for \"{}\": {} {:.0f} %", chosenWay(state), status.stage, 100 * status.fraction);
}

/// "by cell", "traced", "traced in 12 ms".
std::string pictureText(const std::string& name, const EffectImage& image, bool showTimes) {
  return showTimes && !image.image.empty() ? fmt::format("{} in {:.0f} ms", name, image.milliseconds) : name;
}

std::vector<std::string> shownTexts(const EffectPicture& picture, EffectContent content, bool showTimes) {
  const std::string name = content == EffectContent::kByTracing ? "traced" : "by " + picture.wanted.way;
  const std::string traced = pictureText("traced", picture.traced, showTimes);
  std::string text = content == EffectContent::kByTracing ? traced : pictureText(name, picture.byWay, showTimes);
  if (content == EffectContent::kDifference) {
    text += " against " + traced;
  }
  if (picture.secondsLeftOut > 0) {
    return {
        fmt::format("{}: {} would take {:.0f} s", text,
                    picture.isWhole ? "to compare it with the traced one" : "a whole picture", picture.secondsLeftOut),
        name};
  }
  if (!picture.isWhole) {
    return {text + " (small while it moves)", name};
  }
  if (!picture.difference || content == EffectContent::kByTracing) {
    return {text, name};
  }
  return {text + ": " + differenceText(*picture.difference),
          fmt::format("{}: {:.2f} % differ clearly", name, 100 * picture.difference->clearShare()), name};
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

std::vector<std::string> effectNotes(const ViewerState& state, const EffectStatus& status, bool showTimes) {
  if (!status.error.empty()) {
    return {status.error};
  }
  const EffectContent content = state.effect.content;
  if (!status.picture || status.picture->shown(content) == nullptr) {
    return status.busy ? std::vector<std::string>{"in the making: " + workText(state, status), "in the making"}
                       : std::vector<std::string>{"nothing to show"};
  }
  std::vector<std::string> texts = shownTexts(*status.picture, content, showTimes);
  if (status.busy && !status.stage.empty()) {
    for (std::string& text : texts) {
      text += "\n" + workText(state, status);
    }
  }
  return texts;
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
