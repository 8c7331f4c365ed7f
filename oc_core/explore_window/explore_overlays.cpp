#include "oc_core/explore_window/explore_overlays.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "oc_core/explore_window/explore_colors.h"
#include "oc_core/explore_window/explore_gui_pieces.h"
#include "oc_core/explore_window/explore_pane.h"

namespace ocelli {
namespace {

constexpr double kHintSeconds = 9;  // at full strength
constexpr double kHintFadeSeconds = 1.5;

constexpr int kCardFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                           ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing;

/// A card on the image of the view, `share` of its height below its top. End it with ImGui::End().
void beginCard(const ExploreOverlayFrame& frame, const char* name, float share, GuiColor border, uint8_t opacity) {
  const ExplorePaneRect& view = frame.layout.panes.front().rect;
  ImGui::SetNextWindowPos({view.x + view.width / 2, view.y + view.height * share}, ImGuiCond_Always, {0.5f, share});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {std::max(view.width - 24 * frame.scale, 1.0f), view.height});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, kGuiPanel.packed(opacity));
  ImGui::PushStyleColor(ImGuiCol_Border, border.packed(opacity));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {16 * frame.scale, 12 * frame.scale});
  ImGui::Begin(name, nullptr, kCardFlags | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
}

void coloredText(const std::string& text, GuiColor color, uint8_t opacity = 255) {
  ImGui::PushStyleColor(ImGuiCol_Text, color.packed(opacity));
  ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
  ImGui::PopStyleColor();
}

/// One camera of the row above; true where it was clicked.
bool choiceButton(const ExploreOverlayFrame& frame, size_t index, const WindowChoice& choice, bool isChosen) {
  const std::string label = fmt::format("{}  {}", index + 1, choice.name);
  ImGui::PushStyleColor(ImGuiCol_Button, isChosen ? kGuiAccentDeep.packed() : kGuiField.packed());
  ImGui::PushStyleColor(ImGuiCol_Text, isChosen ? kGuiText.packed() : kGuiTextDim.packed());
  const bool clicked = ImGui::Button(label.c_str());
  ImGui::PopStyleColor(2);
  if (isChosen) {
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRectFilled({from.x, to.y - 2 * frame.scale}, to, kGuiAccent.packed());
  }
  return clicked;
}

/// A state that wants attention has a sign, so that colour is not all that tells.
std::string noteText(const WindowNote& note) {
  return note.kind == WindowNoteKind::kAttention ? "!  " + note.text : note.text;
}

std::string figuresText(const ExploreOverlayFrame& frame) {
  std::string text;
  const auto add = [&](const std::string& more) { text += more.empty() ? "" : (text.empty() ? "" : "     ") + more; };
  if (const WindowPicture* picture = frame.target.picture) {
    add(picture->place);
    if (frame.showTimes && frame.framesPerSecond > 0) {
      add(fmt::format("{:.0f} ms, {:.0f} frames/s", picture->milliseconds, frame.framesPerSecond));
    }
  }
  return text;
}

}  // namespace

float exploreHintOpacity(double seconds) {
  return static_cast<float>(std::clamp(1 - (seconds - kHintSeconds) / kHintFadeSeconds, 0.0, 1.0));
}

void drawExploreChoices(const ExploreOverlayFrame& frame) {
  const float scale = frame.scale;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10 * scale, 0));
  beginExploreArea("explore choices", frame.layout.choices, kGuiBackground, 255, true);
  ImGui::PopStyleVar();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(10 * scale, 5 * scale));
  const float height = ImGui::GetTextLineHeight() + 10 * scale;
  ImGui::SetCursorPosY((frame.layout.choices.height - height) / 2);
  if (const WindowPicture* picture = frame.target.picture) {
    for (size_t i = 0; i < picture->choices.size(); ++i) {
      if (choiceButton(frame, i, picture->choices[i], i == picture->chosen)) {
        frame.target.state.formRow = 0;
        frame.target.work.tell([i](ExploreWindowModel& model) {
          model.choose(i);
          return std::string();
        });
      }
      ImGui::SameLine(0, 4 * scale);
    }
    if (picture->chosen < picture->choices.size()) {
      const float left = ImGui::GetCursorPosX() + 12 * scale;
      const float room = frame.layout.choices.width - left - 12 * scale;
      const std::string& meaning = picture->choices[picture->chosen].meaning;
      if (room > 80 * scale) {
        ImGui::SetCursorPosX(left);
        ImGui::AlignTextToFramePadding();
        coloredText(fittedExploreText(meaning, room), kGuiTextDim);
      }
    }
  }
  ImGui::PopStyleVar();
  ImGui::End();
}

void drawExploreTitles(const ExploreOverlayFrame& frame) {
  for (const ExploreWindowLayout::Pane& pane : frame.layout.panes) {
    if (pane.title.height <= 1) {
      continue;
    }
    const ExplorePaneKind& kind = explorePanes()[pane.kind];
    const bool isActive = frame.target.state.active == kind.name;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10 * frame.scale, 0));
    beginExploreArea(fmt::format("title of {}", kind.name).c_str(), pane.title, kGuiPanel, 255, false);
    ImGui::PopStyleVar();
    ImGui::SetCursorPosY((pane.title.height - ImGui::GetTextLineHeight()) / 2);
    coloredText(kind.title, isActive ? kGuiAccent : kGuiText);
    ImGui::SameLine();
    const float width = ImGui::CalcTextSize(kind.keys).x;
    ImGui::SetCursorPosX(pane.title.width - width - 10 * frame.scale);
    coloredText(kind.keys, kGuiTextDim);
    ImGui::End();
  }
}

void drawExploreStatus(const ExploreOverlayFrame& frame) {
  const float scale = frame.scale;
  const ExplorePaneRect& bar = frame.layout.status;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(12 * scale, 0));
  beginExploreArea("explore status", bar, kGuiBackground, 255, false);
  ImGui::PopStyleVar();
  const float y = (bar.height - ImGui::GetTextLineHeight()) / 2;
  const std::string help = "H  help";
  const float helpWidth = ImGui::CalcTextSize(help.c_str()).x;
  const std::string figures = fittedExploreText(figuresText(frame), bar.width * 0.5f);
  const float figuresWidth = ImGui::CalcTextSize(figures.c_str()).x;
  float right = bar.width - helpWidth - 12 * scale;
  ImGui::SetCursorPos({right, y});
  coloredText(help, kGuiAccent);
  right -= figuresWidth + 20 * scale;
  ImGui::SetCursorPos({right, y});
  coloredText(figures, kGuiTextDim);
  float left = 12 * scale;
  if (frame.target.state.recording) {
    ImGui::SetCursorPos({left, y});
    const std::string text = "recording";
    ImGui::GetWindowDrawList()->AddCircleFilled({bar.x + left + 5 * scale, bar.y + bar.height / 2}, 5 * scale,
                                                kOkabeItoVermillion.packed());
    ImGui::SetCursorPos({left + 16 * scale, y});
    coloredText(text, kGuiText);
    left += 16 * scale + ImGui::CalcTextSize(text.c_str()).x + 20 * scale;
  }
  if (const WindowPicture* picture = frame.target.picture) {
    for (const WindowNote& note : picture->notes) {
      const float room = right - left - 16 * scale;
      if (room < 40 * scale) {
        break;
      }
      const std::string text = fittedExploreText(noteText(note), room);
      ImGui::SetCursorPos({left, y});
      coloredText(text, note.kind == WindowNoteKind::kAttention ? kExploreAttention : kGuiText);
      left += ImGui::CalcTextSize(text.c_str()).x + 24 * scale;
    }
  }
  ImGui::End();
}

void drawExploreHint(const ExploreOverlayFrame& frame) {
  const float opacity = exploreHintOpacity(frame.target.state.hintSeconds);
  if (frame.target.picture == nullptr || opacity <= 0 || frame.target.state.help ||
      !frame.target.state.message.empty()) {
    return;
  }
  const auto strength = static_cast<uint8_t>(std::lround(opacity * 235));
  const float scale = frame.scale;
  beginCard(frame, "explore hint", 0.94f, kGuiBorder, strength);
  const auto pair = [&](const char* keys, const char* meaning, bool last = false) {
    coloredText(keys, kOkabeItoYellow, strength);
    ImGui::SameLine(0, 8 * scale);
    coloredText(meaning, kGuiText, strength);
    if (!last) {
      ImGui::SameLine(0, 22 * scale);
    }
  };
  pair("W A S D", "walk");
  pair("Drag", "look");
  pair("1 2 3 ...", "choose a camera");
  pair("Click", "pick");
  pair("H", "help", true);
  ImGui::End();
}

void drawExploreProgress(const ExploreOverlayFrame& frame) {
  const WindowPicture* picture = frame.target.picture;
  const bool isBeside = frame.status.stage.empty() && picture != nullptr;
  std::string stage = isBeside ? picture->stage : frame.status.stage;
  if (stage.empty() && picture == nullptr) {
    stage = "opening the scene";
  }
  const double fraction = isBeside ? picture->fraction : frame.status.fraction;
  if (stage.empty()) {
    return;
  }
  beginCard(frame, "explore progress", picture == nullptr ? 0.5f : 0.04f, kGuiAccent, 245);
  const float width = 320 * frame.scale;
  ImGui::TextUnformatted(fmt::format("{} ...", stage).c_str());
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, kGuiAccentDeep.packed());
  ImGui::ProgressBar(static_cast<float>(fraction), {width, 0}, fmt::format("{:.0f} %", 100 * fraction).c_str());
  ImGui::PopStyleColor();
  ImGui::End();
}

void drawExploreMessage(const ExploreOverlayFrame& frame) {
  const ExploreWindowState& state = frame.target.state;
  if (state.message.empty()) {
    return;
  }
  beginCard(frame, "explore message", 0.94f, state.messageIsError ? kOkabeItoVermillion : kGuiAccent, 250);
  const ExplorePaneRect& view = frame.layout.panes.front().rect;
  if (state.messageIsError) {
    coloredText("That did not work", kExploreAttention);
  }
  ImGui::PushTextWrapPos(std::min(560 * frame.scale, view.width - 64 * frame.scale));
  ImGui::TextUnformatted(state.message.c_str());
  ImGui::PopTextWrapPos();
  if (state.messageIsError) {
    coloredText("Escape closes this", kGuiTextDim);
  }
  ImGui::End();
}

}  // namespace ocelli
