#include "display_sim/viewer/lens_overlays.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "display_sim/viewer/lens_choice.h"
#include "display_sim/viewer/shown_picture.h"
#include "display_sim/viewer/viewer_colors.h"

namespace ocelli {
namespace {

constexpr GuiColor kLensColor{255, 255, 255};
constexpr GuiColor kChosenLensColor = kOkabeItoYellow;
constexpr GuiColor kCasingColor{0, 0, 0};
constexpr float kHandleHalf = 4;

struct LensLook {
  ImDrawList& list;
  GuiColor color;
  float width;
  float scale;
};

void line(const LensLook& look, const ImVec2& a, const ImVec2& b) {
  look.list.AddLine(a, b, kCasingColor.packed(200), look.width + 2 * look.scale);
  look.list.AddLine(a, b, look.color.packed(), look.width);
}

void dashes(const LensLook& look, const ImVec2& a, const ImVec2& b) {
  const float length = std::hypot(b.x - a.x, b.y - a.y);
  const float step = 9 * look.scale;
  for (float at = 0; at < length; at += step) {
    const float from = at / length;
    const float to = std::min((at + step * 0.55f) / length, 1.0f);
    line(look, {a.x + (b.x - a.x) * from, a.y + (b.y - a.y) * from}, {a.x + (b.x - a.x) * to, a.y + (b.y - a.y) * to});
  }
}

void rectangle(const LensLook& look, const ImVec2& a, const ImVec2& b, bool isDashed) {
  const auto edge = [&](const ImVec2& from, const ImVec2& to) {
    isDashed ? dashes(look, from, to) : line(look, from, to);
  };
  edge(a, {b.x, a.y});
  edge({b.x, a.y}, b);
  edge(b, {a.x, b.y});
  edge({a.x, b.y}, a);
}

void handle(const LensLook& look, const ImVec2& at, bool isRound) {
  const float half = kHandleHalf * look.scale;
  const float casing = half + 1.5f * look.scale;
  if (isRound) {
    look.list.AddCircleFilled(at, casing, kCasingColor.packed());
    look.list.AddCircleFilled(at, half, look.color.packed());
    return;
  }
  look.list.AddRectFilled({at.x - casing, at.y - casing}, {at.x + casing, at.y + casing}, kCasingColor.packed());
  look.list.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, look.color.packed());
}

/// Number and zoom, in the region's upper left corner; left out where the region has no room for it.
void label(const LensLook& look, const std::string& text, const ImVec2& a, const ImVec2& b) {
  const float margin = 4 * look.scale;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 corner(a.x + 2 * margin, a.y + 2 * margin);
  if (corner.x + size.x + 2 * margin > b.x || corner.y + size.y + margin > b.y) {
    return;
  }
  look.list.AddRectFilled(corner, {corner.x + size.x + 2 * margin, corner.y + size.y}, kGuiBackground.packed(205),
                          3 * look.scale);
  look.list.AddText({corner.x + margin, corner.y}, look.color.packed(), text.c_str());
}

}  // namespace

LensPointer::Frame lensFrame(const ViewerState& state, const WindowRect& image, float lengthScale) {
  const ReconstructionPane::Place place =
      picturePlace(state, {static_cast<int>(std::lround(image.width)), static_cast<int>(std::lround(image.height))});
  return {glm::dvec2(image.x, image.y) + glm::dvec2(place.corner), glm::dvec2(place.size),
          static_cast<double>(lengthScale)};
}

void drawLensOutlines(const PanelDrawing& drawing, const WindowRect& image) {
  const ViewerState& state = drawing.state;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({image.x, image.y}, {image.right(), image.bottom()});
  const LensPointer::Frame frame = lensFrame(state, image, drawing.scale);
  const auto at = [&](const glm::dvec2& share) {
    const glm::dvec2 place = frame.corner + share * frame.size;
    return ImVec2(static_cast<float>(place.x), static_cast<float>(place.y));
  };
  const std::vector<GpcRegion>& lenses = state.work.camera.gpc.regions;
  for (size_t i = 0; i < lenses.size(); ++i) {
    const bool isChosen = state.lenses.chosen == i;
    const bool locked = isLocked(state, i);
    const LensLook look{list, isChosen ? kChosenLensColor : kLensColor, (isChosen ? 2.0f : 1.2f) * drawing.scale,
                        drawing.scale};
    const LensBox inner = lensInnerBox(lenses[i]);
    const LensBox outer = lensBox(lenses[i]);
    rectangle(look, at(outer.lower), at(outer.upper), true);
    rectangle(look, at(inner.lower), at(inner.upper), false);
    if (!locked) {
      for (int k = 0; k < 4; ++k) {
        handle(look, at(cornerOf(lenses[i], static_cast<LensCorner>(k))), false);
      }
      const glm::dvec2 middle(lenses[i].center);
      handle(look, at({middle.x, outer.lower.y}), true);
      handle(look, at({middle.x, outer.upper.y}), true);
      handle(look, at({outer.lower.x, middle.y}), true);
      handle(look, at({outer.upper.x, middle.y}), true);
    }
    label(look, fmt::format("{}: {:.3g}x{}", i + 1, lenses[i].zoom, locked ? ", locked" : ""), at(inner.lower),
          at(inner.upper));
  }
  list.PopClipRect();
}

std::string lensDetail(const ViewerState& state, const LensStatus& status) {
  const GpcLayout& layout = state.work.camera.gpc;
  const std::string text = fmt::format("{}, {} {}", layout.sampling->name, layout.regions.size(),
                                       layout.regions.size() == 1 ? "lens" : "lenses");
  return status.picture ? fmt::format("{}, {} x {}", text, status.picture->wanted.size.x, status.picture->wanted.size.y)
                        : text;
}

std::vector<std::string> lensNotes(const ViewerState& state, const LensStatus& status, bool showTimes) {
  if (!status.error.empty()) {
    return {status.error};
  }
  if (!status.picture) {
    return {status.busy ? "in the making ..." : "nothing to show"};
  }
  const std::string time =
      showTimes ? fmt::format("{}: {:.0f} ms, {:.1f} pictures a second", nameOf(status.picture->wanted.method),
                              status.picture->milliseconds, 1000 / std::max(status.picture->milliseconds, 1.0))
                : std::string(nameOf(status.picture->wanted.method));
  const std::string text = status.picture->isWhole ? time : time + " (small while it moves)";
  if (!state.lenses.chosen) {
    return {text + "\nclick: add a lens; drag one to move it, its corners to size it, its dashed edge to widen it",
            text};
  }
  const GpcRegion& lens = state.work.camera.gpc.regions[*state.lenses.chosen];
  return {fmt::format("{}\nlens {}: centre {:.3f} {:.3f}, extent {:.3f} {:.3f}, zoom {:.2f}, transition {:.2f}", text,
                      *state.lenses.chosen + 1, lens.center.x, lens.center.y, lens.extent.x, lens.extent.y, lens.zoom,
                      lens.transitionWidth),
          text};
}

}  // namespace ocelli
