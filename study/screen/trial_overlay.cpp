#include "study/screen/trial_overlay.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "study/screen/estimate_drawing.h"
#include "study/screen/study_pieces.h"

namespace ocelli {
namespace {

void drawPrompt(StudyCanvas& canvas, const TrialLayout& layout, SceneViews& views) {
  const MirrorScope mirrored(canvas, canvas.texts().rightToLeft());
  const std::string unwell = canvas.texts().say("unwell_hint");
  const PixelRect strip{0, 0, static_cast<double>(canvas.width()),
                        static_cast<double>(promptHeight({canvas.width(), canvas.height(), 60}))};
  canvas.fill(strip, kStudyBackground);
  const double middle = strip.center().y;
  const double gap = canvas.length(12);

  // What ends the session, at the right.
  const double textTop = middle - canvas.look().textPixels(StudyText::kSmall) / 2;
  const double right = strip.right() - canvas.length(24);
  canvas.writeLine({StudyText::kSmall, kStudyTextDim, kStudyBackground, TextAlign::kRight}, {right, textTop}, unwell);
  const double capLeft = right - canvas.widthOf(unwell, StudyText::kSmall) - gap - keyCapWidth(canvas, kUnwellKey);
  drawKeyCap(canvas, capLeft, middle, kUnwellKey, kStudyBackground);

  double left = canvas.length(24);
  const double size = std::floor(strip.height - canvas.length(8));
  const bool sought = layout.scene != nullptr && layout.targetObject.has_value();
  const double room = capLeft - gap - left - (sought ? size + 2 * gap : 0);
  std::string prompt = layout.prompt;
  const bool fits = canvas.widthOf(prompt, StudyText::kStrong) <= room;
  const StudyText style = fits ? StudyText::kStrong : StudyText::kSmall;
  left = canvas.writeLine({style, kStudyText, kStudyBackground}, {left, middle - canvas.look().textPixels(style) / 2},
                          prompt);
  if (sought) {
    const PixelRect place{std::round(left + gap), std::round(middle - size / 2), size, size};
    canvas.fill(place, kStudyField, canvas.length(6));
    canvas.image(views.portraitOf(*layout.scene, *layout.targetObject, static_cast<int>(size)), place);
    canvas.outline(place, kStudyLine, canvas.length(1.5), canvas.length(6));
  }
}

std::string keyLabel(Key key) {
  return std::string(nameOf(key));
}

bool holdsMap(const TrialLayout& layout, const PixelRect& place) {
  return std::ranges::any_of(layout.maps,
                             [&](const TrialLayout::PathMap& map) { return place.contains(map.place.center()); });
}

void drawChoice(StudyCanvas& canvas, const TrialLayout::Choice& choice, bool aroundMap) {
  const double rounding = canvas.length(10);
  const GuiColor background = choice.chosen ? kStudyAccentDeep : (aroundMap ? kStudyCard : kStudyField);
  const PixelRect& place = choice.place;
  canvas.fill(place, background, rounding);
  canvas.outline(place, choice.chosen ? kStudyAccent : kStudyLine, canvas.length(choice.chosen ? 4 : 1.5), rounding);
  const std::string key = keyLabel(choice.key);
  const double text = canvas.look().textPixels(StudyText::kStrong);
  const double pad = canvas.length(10);
  if (aroundMap) {
    const double x = drawKeyCap(canvas, place.left + pad, place.top + pad + text / 2, key, background);
    if (choice.label != key) {
      canvas.writeLine({StudyText::kStrong, kStudyText, background}, {x + pad, place.top + pad}, choice.label);
    }
  } else if (choice.label == key) {
    const StudyText style =
        place.height > 2 * canvas.lineHeight(StudyText::kTitle) ? StudyText::kTitle : StudyText::kStrong;
    canvas.writeLine({style, kStudyText, background, TextAlign::kCenter},
                     {place.center().x, place.center().y - canvas.look().textPixels(style) / 2}, choice.label);
  } else {
    const double width = keyCapWidth(canvas, key) + pad + canvas.widthOf(choice.label, StudyText::kStrong);
    const double left = std::max(place.left + pad, place.center().x - width / 2);
    const double x = drawKeyCap(canvas, left, place.center().y, key, background);
    canvas.writeLine({StudyText::kStrong, kStudyText, background}, {x + pad, place.center().y - text / 2},
                     choice.label);
  }
  if (choice.chosen) {
    const double size = canvas.length(20);
    drawTick(canvas, {place.right() - size, place.top + size}, size, kStudyAccent, canvas.length(4));
  }
}

/// Seen on light and on dark.
void drawPointer(StudyCanvas& canvas, const glm::dvec2& at) {
  const double radius = canvas.length(13);
  for (const auto& [color, extra] : {std::pair(kStudyInk, 3.0), std::pair(GuiColor{255, 255, 255}, 0.0)}) {
    const double thickness = canvas.length(3 + extra);
    canvas.ring(at, radius, color, thickness);
    for (const glm::dvec2 way : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)}) {
      const std::array tick{at + way * (radius - canvas.length(4)), at + way * (radius + canvas.length(7))};
      canvas.line(tick, color, thickness);
    }
    canvas.disc(at, canvas.length(2 + extra / 2), color);
  }
}

}  // namespace

void drawPathMap(StudyCanvas& canvas, const PixelRect& place, std::span<const glm::dvec2> corners,
                 GuiColor background) {
  if (corners.size() < 2) {
    return;
  }
  glm::dvec2 lower(std::numeric_limits<double>::max());
  glm::dvec2 upper(std::numeric_limits<double>::lowest());
  for (const glm::dvec2& corner : corners) {
    lower = glm::min(lower, corner);
    upper = glm::max(upper, corner);
  }
  const glm::dvec2 extent = glm::max(upper - lower, glm::dvec2(1e-6));
  const double margin = canvas.length(34);
  const double textPixels = canvas.look().textPixels(StudyText::kSmall);
  const double scale =
      std::min((place.width - 2 * margin) / extent.x, (place.height - 2 * margin - textPixels) / extent.y);
  std::vector<glm::dvec2> path;
  for (const glm::dvec2& corner : corners) {
    path.push_back(place.center() + scale * (corner - (lower + upper) / 2.0));
  }
  const double thickness = canvas.length(6);
  const glm::dvec2 last = path.back();
  const glm::dvec2 forward = glm::normalize(last - path[path.size() - 2]);
  const glm::dvec2 side(-forward.y, forward.x);
  const double head = canvas.length(20);
  path.back() = last - forward * head * 0.6;
  canvas.line(path, kStudyText, thickness);
  canvas.triangle(last + forward * head * 0.5, last - forward * head * 0.6 + side * head * 0.6,
                  last - forward * head * 0.6 - side * head * 0.6, kStudyText);
  const double radius = canvas.length(10);
  canvas.disc(path.front(), radius, kOkabeItoOrange);
  canvas.ring(path.front(), radius, kStudyInk, canvas.length(2));
  // The word stands where the path does not go: beyond the dot, away from the first leg.
  const glm::dvec2 away = -glm::normalize(path[1] - path[0]);
  const std::string start = canvas.texts().say("start");
  const double width = canvas.widthOf(start, StudyText::kSmall);
  const glm::dvec2 middle =
      path.front() + away * (radius + canvas.length(5) + (std::abs(away.x) > 0.5 ? width / 2 : textPixels / 2));
  const double x =
      std::clamp(middle.x, place.left + width / 2 + canvas.length(8), place.right() - width / 2 - canvas.length(8));
  const double y = std::clamp(middle.y - textPixels / 2, place.top + 2, place.bottom() - textPixels - 2);
  canvas.writeLine({StudyText::kSmall, kStudyText, background, TextAlign::kCenter}, {x, y}, start);
}

void drawChoicesAndMaps(StudyCanvas& canvas, const TrialLayout& layout) {
  for (const TrialLayout::Choice& choice : layout.choices) {
    drawChoice(canvas, choice, holdsMap(layout, choice.place));
  }
  for (const TrialLayout::PathMap& map : layout.maps) {
    const auto around = std::ranges::find_if(
        layout.choices, [&](const TrialLayout::Choice& choice) { return choice.place.contains(map.place.center()); });
    const bool hasChoice = around != layout.choices.end();
    if (!hasChoice) {
      canvas.fill(map.place, kStudyCard, canvas.length(10));
    }
    drawPathMap(canvas, map.place, map.corners, hasChoice && around->chosen ? kStudyAccentDeep : kStudyCard);
  }
}

void drawTrialOverlay(StudyCanvas& canvas, const TrialLayout& layout, SceneViews& views) {
  // What a trial shows has its place on the screen.
  const MirrorScope unmirrored(canvas, false);
  drawPrompt(canvas, layout, views);
  drawChoicesAndMaps(canvas, layout);
  if (layout.scale) {
    drawScale(canvas, *layout.scale);
  }
  if (layout.dial) {
    drawDial(canvas, *layout.dial);
  }
  if (layout.pointer) {
    drawPointer(canvas, *layout.pointer);
  }
}

}  // namespace ocelli
