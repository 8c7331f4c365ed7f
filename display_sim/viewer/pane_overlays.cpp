#include "display_sim/viewer/pane_overlays.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "display_sim/viewer/display_pane.h"
#include "display_sim/viewer/effect_overlays.h"
#include "display_sim/viewer/gui_pieces.h"
#include "display_sim/viewer/lens_overlays.h"
#include "display_sim/viewer/transfer_overlays.h"
#include "display_sim/viewer/viewer_colors.h"
#include "display_sim/viewer/volume_notes.h"

namespace ocelli {
namespace {

struct LegendEntry {
  GuiColor color;
  std::string text;
};

/// At the bottom of a pane, on a dimmed ground; to the right in the scene's, where there is less to hide.
void drawLegend(Pane pane, const WindowRect& image, const std::vector<LegendEntry>& entries, float scale) {
  if (entries.empty()) {
    return;
  }
  const float line = ImGui::GetTextLineHeight() + 3 * scale;
  const float swatch = 11 * scale;
  const float margin = 8 * scale;
  float width = 0;
  for (const LegendEntry& entry : entries) {
    width = std::max(width, ImGui::CalcTextSize(entry.text.c_str()).x);
  }
  const ImVec2 size(width + swatch + 3 * margin, static_cast<float>(entries.size()) * line + margin);
  if (size.x > image.width - 2 * margin || size.y > image.height - 2 * margin) {
    return;  // the pane is too small for it
  }
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float left = pane == Pane::kScene ? image.right() - margin - size.x : image.x + margin;
  const ImVec2 corner(left, image.bottom() - margin - size.y);
  list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, kGuiBackground.packed(205), 4 * scale);
  float y = corner.y + margin / 2 + 1.5f * scale;
  for (const LegendEntry& entry : entries) {
    const float top = y + (ImGui::GetTextLineHeight() - swatch) / 2;
    list.AddRectFilled({corner.x + margin, top}, {corner.x + margin + swatch, top + swatch}, entry.color.packed(),
                       2 * scale);
    list.AddRect({corner.x + margin, top}, {corner.x + margin + swatch, top + swatch}, kGuiTextDim.packed(), 2 * scale);
    list.AddText({corner.x + 2 * margin + swatch, y}, kGuiText.packed(), entry.text.c_str());
    y += line;
  }
}

constexpr float kNoteMargin = 8;

/// How wide a note may be.
float noteRoom(const WindowRect& image, float scale) {
  return image.width - 4 * kNoteMargin * scale;
}

/// The first one that takes no more than a quarter of the pane's height, or the last one.
std::string noteThatFits(const WindowRect& image, const std::vector<std::string>& notes, float scale) {
  for (const std::string& note : notes) {
    if (ImGui::CalcTextSize(note.c_str(), nullptr, false, noteRoom(image, scale)).y <= image.height / 4) {
      return note;
    }
  }
  return notes.back();
}

/// A line of text on a dimmed ground, at the top left of a pane.
void drawNote(const WindowRect& image, const std::string& text, float scale) {
  const float margin = kNoteMargin * scale;
  const float room = noteRoom(image, scale);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, room);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 corner(image.x + margin, image.y + margin);
  list.AddRectFilled(corner, {corner.x + size.x + 2 * margin, corner.y + size.y + margin}, kGuiBackground.packed(205),
                     4 * scale);
  list.AddText(nullptr, 0, {corner.x + margin, corner.y + margin / 2}, kGuiText.packed(), text.c_str(), nullptr, room);
}

std::string detailOf(const PanelDrawing& drawing, Pane pane) {
  const ViewerState& state = drawing.state;
  const ViewerFacts& facts = drawing.facts;
  const ReferenceImage* image = shownImage(state, *facts.data);
  const bool hasImages = facts.data->camera && !facts.data->camera->representation.images.empty();
  if (!facts.failures[static_cast<size_t>(pane)].empty()) {
    return {};
  }
  switch (pane) {
    case Pane::kScene:
      return facts.data->rays && hasImages
                 ? fmt::format("{} rays, {} of them bent", facts.straightRays + facts.bentRays, facts.bentRays)
                 : std::string();
    case Pane::kReference: {
      if (image == nullptr) {
        return facts.data->camera ? facts.data->camera->choice.name : std::string();
      }
      const size_t count = facts.data->camera->representation.images.size();
      const std::string which = count > 1 ? fmt::format("{} of {}, ", state.reference.image + 1, count) : std::string();
      return fmt::format("{}, {}{} x {}, {}", image->camera, which, image->width(), image->height(),
                         nameOf(state.reference.quantity));
    }
    case Pane::kReconstruction:
      return facts.missing ? missingText(*facts.missing) : std::string(facts.data->camera ? "moving" : "");
    case Pane::kDisplay: {
      if (!facts.data->volume) {
        return {};
      }
      const DisplayProfile& profile = facts.data->volume->volume.profile();
      if (state.display.running && looksSteady(state.display, profile)) {
        return fmt::format("{}, speed {}", profile.name, speedText(state.display.speed));
      }
      const int slices = profile.slicesPerHalfTurn;
      const int slice = static_cast<int>(std::lround(state.display.sweepDegrees / 180 * slices)) % slices;
      return fmt::format("{}, {} {}, slice {} of {}", profile.name, state.display.running ? "speed" : "stopped at",
                         speedText(state.display.speed), slice + 1, slices);
    }
    case Pane::kEffect:
      return effectDetail(state, facts.effect);
    case Pane::kLenses:
      return lensDetail(state, facts.lenses);
    case Pane::kVolume:
      return volumeDetail(state, facts.volume);
    case Pane::kTransfer:
      return transferDetail(state);
  }
  return {};
}

/// As many of the parts between commas as the room holds.
std::string startThatFits(std::string text, float room) {
  while (!text.empty() && ImGui::CalcTextSize(text.c_str()).x > room) {
    const size_t comma = text.rfind(", ");
    text.resize(comma == std::string::npos ? 0 : comma);
  }
  return text;
}

void drawHeader(const PanelDrawing& drawing, const PaneLayout& layout) {
  const bool active = layout.pane == drawing.state.active;
  const std::string name = fmt::format("header {}", titleOf(layout.pane));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10 * drawing.scale, 0));
  beginFixedWindow(name.c_str(), layout.header, active ? kGuiAccentDeep : kGuiPanel,
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  ImGui::SetCursorPosY((layout.header.height - ImGui::GetTextLineHeight()) / 2);
  ImGui::TextUnformatted(fmt::format("{}  {}", static_cast<int>(layout.pane) + 1, titleOf(layout.pane)).c_str());
  ImGui::SameLine();
  const float left = ImGui::GetCursorPosX() + 8 * drawing.scale;
  const std::string detail =
      startThatFits(detailOf(drawing, layout.pane), layout.header.width - 10 * drawing.scale - left);
  const float right = layout.header.width - ImGui::CalcTextSize(detail.c_str()).x - 10 * drawing.scale;
  if (right >= left) {
    ImGui::SetCursorPosX(right);
    ImGui::PushStyleColor(ImGuiCol_Text, active ? kGuiText.packed() : kGuiTextDim.packed());
    ImGui::TextUnformatted(detail.c_str());
    ImGui::PopStyleColor();
  }
  if (ImGui::IsWindowHovered()) {
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
      const bool alone = drawing.state.maximised.has_value();
      drawing.state.maximised = alone ? std::nullopt : std::optional(layout.pane);
    }
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
      drawing.state.active = layout.pane;
    }
  }
  ImGui::End();
}

/// Of the sampling rates over the picture with lenses.
std::vector<LegendEntry> rateLegend(const ViewerState& state) {
  std::vector<LegendEntry> entries;
  if (!state.lenses.rates) {
    return entries;
  }
  const RateRange range = rateRangeOf(state.work.camera.gpc);
  for (const double share : {1.0, 0.5, 0.0}) {
    const double rate = range.least * std::pow(range.greatest / range.least, share);
    const Rgb8 color = rateColor(rate, range);
    entries.push_back({{color.x, color.y, color.z}, fmt::format("{:.2f} samples for each one of a pinhole", rate)});
  }
  return entries;
}

std::vector<LegendEntry> legendOf(const PanelDrawing& drawing, Pane pane) {
  const ViewerState& state = drawing.state;
  const ViewerFacts& facts = drawing.facts;
  if (pane == Pane::kEffect) {
    const auto& picture = facts.effect.picture;
    if (state.effect.content != EffectShown::Content::kDifference || !picture || !picture->difference) {
      return {};
    }
    return {{kRampLight, fmt::format("differs by {} of 255 or more", kHottestDifference)},
            {kRampDark, "differs by 1"},
            {{32, 32, 32}, "as traced: dark grey"}};
  }
  if (pane == Pane::kLenses) {
    return rateLegend(state);
  }
  if (!facts.data->camera) {
    return {};
  }
  std::vector<LegendEntry> entries;
  switch (pane) {
    case Pane::kScene:
      if (state.scene.rays && facts.bentRays > 0) {
        entries.push_back({kBentRayColor, "bent rays"});
      }
      if (state.scene.rays && state.scene.straightRays && facts.straightRays > 0) {
        entries.push_back({kRayColor, "straight rays, reference view"});
      } else if (state.scene.frustum) {
        entries.push_back({kReferenceColor, "reference view"});
      }
      if (state.scene.cell) {
        const bool segment = facts.data->camera->choice.isForSegment();
        entries.push_back({kCellColor, segment ? "view segment" : "view cell"});
      }
      entries.push_back({kEyeColor, "your eye"});
      return entries;
    case Pane::kReference: {
      const ReferenceScale& scale = facts.scale;
      if (state.reference.quantity == ReferenceShown::Quantity::kDepth) {
        return {{kRampLight, fmt::format("near, z {:.3f}", scale.nearest)},
                {kRampDark, fmt::format("far, z {:.3f}", scale.farthest)}};
      }
      if (state.reference.quantity == ReferenceShown::Quantity::kDisplacement) {
        return {{kRampLight, fmt::format("{:.1f} pixels", scale.longestDisplacement)}, {kRampDark, "0 pixels"}};
      }
      return {};
    }
    case Pane::kReconstruction:
      if (state.reconstruction.content == ReconstructionShown::Content::kMarked ||
          state.reconstruction.content == ReconstructionShown::Content::kSideBySide) {
        return {{kMissingThickGui, "missing, three pixels wide or more"}, {kMissingGui, "missing"}};
      }
      return {};
    case Pane::kDisplay:
    case Pane::kEffect:
    case Pane::kLenses:
    case Pane::kVolume:
    case Pane::kTransfer:
      return {};
  }
  return {};
}

void drawReconstructionCaption(const PanelDrawing& drawing, const PaneLayout& layout) {
  using Content = ReconstructionShown::Content;
  const Content content = drawing.state.reconstruction.content;
  if (content == Content::kSideBySide) {
    drawNote(layout.image, "left: what stands for the scene    right: the scene itself", drawing.scale);
  } else if (content == Content::kTruth || (content == Content::kBlink && blinkShowsTruth(drawing.state))) {
    drawNote(layout.image, "the scene itself", drawing.scale);
  } else if (content == Content::kBlink) {
    drawNote(layout.image, "what stands for the scene", drawing.scale);
  }
}

/// Of panes that are told in words what they show, or why nothing, from the longest to the shortest form.
std::optional<std::vector<std::string>> notesOf(const PanelDrawing& drawing, Pane pane) {
  const ViewerState& state = drawing.state;
  const ViewerFacts& facts = drawing.facts;
  if (pane == Pane::kVolume || pane == Pane::kTransfer) {
    if (!state.volume.on) {
      return {{"the scene is no volume", "no volume"}};
    }
    return pane == Pane::kVolume ? volumeNotes(facts) : std::vector<std::string>();
  }
  if (!hasMesh(state) && pane != Pane::kDisplay) {
    return {
        {"this pane shows triangles, and a volume has none: choose the value of a surface in the panel, or give "
         "--iso VALUE",
         "needs a surface: --iso"}};
  }
  if (pane == Pane::kEffect) {
    return effectNotes(state, facts.effect, facts.showTimes);
  }
  if (pane == Pane::kLenses) {
    return lensNotes(state, facts.lenses, facts.showTimes);
  }
  return std::nullopt;
}

void drawNotes(const PanelDrawing& drawing, const PaneLayout& layout) {
  const ViewerFacts& facts = drawing.facts;
  const std::string& failure = facts.failures[static_cast<size_t>(layout.pane)];
  if (!failure.empty()) {
    drawNote(layout.image, failure, drawing.scale);
    return;
  }
  if (const auto notes = notesOf(drawing, layout.pane)) {
    if (!notes->empty()) {
      drawNote(layout.image, noteThatFits(layout.image, *notes, drawing.scale), drawing.scale);
    }
    return;
  }
  const bool empty = layout.pane == Pane::kScene     ? !facts.data->scene
                     : layout.pane == Pane::kDisplay ? !facts.data->volume
                                                     : !facts.data->camera;
  if (empty) {
    drawNote(layout.image, facts.work.busy ? "in the making ..." : "nothing to show", drawing.scale);
    return;
  }
  if (layout.pane == Pane::kDisplay && !facts.displayProblem.empty()) {
    drawNote(layout.image, facts.displayProblem, drawing.scale);
  }
  if (layout.pane == Pane::kReconstruction) {
    drawReconstructionCaption(drawing, layout);
  }
  const ReferenceImage* image = shownImage(drawing.state, *facts.data);
  if (layout.pane == Pane::kReference && image == nullptr) {
    drawNote(layout.image, "this camera has no image", drawing.scale);
  }
  if (layout.pane == Pane::kReference && facts.picked && image != nullptr) {
    drawNote(layout.image, sampleText(*image, facts.picked->pixel), drawing.scale);
  }
}

}  // namespace

std::string sampleText(const ReferenceImage& image, const glm::ivec2& pixel) {
  const std::string where = fmt::format("pixel {}, {}: ", pixel.x, pixel.y);
  const float z = image.t(pixel.x, pixel.y);
  if (!(z > 0)) {
    return where + "no sample";
  }
  const auto hundredths = [](float value) { return std::round(value * 100) / 100 + 0.0f; };  // no "-0.00"
  const glm::vec2 d = image.displacement(pixel.x, pixel.y);
  const glm::vec3 c = image.color(pixel.x, pixel.y);
  return fmt::format("{}z {:.4f}, displaced {:.2f} {:.2f}\ncolour {:.2f} {:.2f} {:.2f} (linear)", where, z,
                     hundredths(d.x), hundredths(d.y), c.x, c.y, c.z);
}

std::string missingText(const MissingSamples& missing) {
  return fmt::format("missing {:.2f} %, thick {:.2f} %", 100 * missing.strictRatio(), 100 * missing.thickRatio());
}

void drawPaneOverlays(const PanelDrawing& drawing) {
  for (const PaneLayout& layout : drawing.layout.panes) {
    drawHeader(drawing, layout);
    WindowRect room = layout.image;
    if (layout.pane == Pane::kEffect) {
      room.height -= drawEffectSwitch(drawing, room);
    }
    if (layout.pane == Pane::kLenses) {
      drawLensOutlines(drawing, layout.image);
    }
    if (layout.pane == Pane::kTransfer) {
      drawTransferPlot(drawing, layout.image);
    }
    drawLegend(layout.pane, room, legendOf(drawing, layout.pane), drawing.scale);
    drawNotes(drawing, layout);
  }
}

}  // namespace ocelli
