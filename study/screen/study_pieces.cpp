#include "study/screen/study_pieces.h"

#include <array>
#include <cctype>

namespace ocelli {
namespace {

constexpr double kCapPadding = 9;  // at 1280 x 800, as all lengths here

double capHeight(const StudyCanvas& canvas) {
  return canvas.look().textPixels(StudyText::kSmall) + canvas.length(8);
}

}  // namespace

double keyCapWidth(const StudyCanvas& canvas, const std::string& name) {
  return std::max(canvas.widthOf(canvas.texts().keyName(name), StudyText::kSmall) + 2 * canvas.length(kCapPadding),
                  capHeight(canvas));
}

double drawKeyCap(StudyCanvas& canvas, double left, double middle, const std::string& name, GuiColor background) {
  const double height = capHeight(canvas);
  const double width = keyCapWidth(canvas, name);
  const PixelRect cap{left, middle - height / 2, width, height};
  canvas.fill(cap, background, canvas.length(5));
  canvas.outline(cap, kStudyTextDim, canvas.length(1.5), canvas.length(5));
  canvas.writeLine({StudyText::kSmall, kStudyText, background, TextAlign::kCenter},
                   {cap.center().x, cap.center().y - canvas.look().textPixels(StudyText::kSmall) / 2},
                   canvas.texts().keyName(name));
  return cap.right();
}

double buttonWidth(const StudyCanvas& canvas, const ButtonLook& look) {
  const double key = look.key.empty() ? 0 : keyCapWidth(canvas, look.key) + canvas.length(14);
  return canvas.widthOf(look.label, StudyText::kStrong) + key + 2 * canvas.length(24);
}

bool drawButton(StudyCanvas& canvas, const std::string& name, const PixelRect& place, const ButtonLook& look) {
  const Touch touch = look.enabled ? canvas.touch(name, place) : Touch();
  const bool lit = look.primary && look.enabled;
  GuiColor background = lit ? kStudyAccentDeep : kStudyField;
  if (touch.hovered && !touch.held) {
    background = lit ? GuiColor{31, 90, 126} : kStudyFieldHovered;
  }
  const double rounding = canvas.length(10);
  canvas.fill(place, background, rounding);
  canvas.outline(place, lit ? kStudyAccent : kStudyLine, canvas.length(lit ? 2 : 1.5), rounding);
  if (look.focused) {
    drawFocusRing(canvas, place, rounding);
  }
  const GuiColor text = look.enabled ? kStudyText : kStudyTextDim;
  double x = place.left + canvas.length(24);
  const double y = place.center().y - canvas.look().textPixels(StudyText::kStrong) / 2;
  x = canvas.writeLine({StudyText::kStrong, text, background}, {x, y}, look.label);
  if (!look.key.empty()) {
    drawKeyCap(canvas, x + canvas.length(14), place.center().y, look.key, background);
  }
  return touch.clicked;
}

void drawTick(StudyCanvas& canvas, const glm::dvec2& at, double size, GuiColor color, double thickness) {
  const glm::dvec2 center = canvas.onScreen(at);
  const MirrorScope unmirrored(canvas, false);
  const std::array tick{center + size * glm::dvec2(-0.5, 0.02), center + size * glm::dvec2(-0.14, 0.36),
                        center + size * glm::dvec2(0.5, -0.36)};
  canvas.line(tick, color, thickness);
}

void drawVerdict(StudyCanvas& canvas, const glm::dvec2& center, double radius, bool good) {
  canvas.disc(center, radius, good ? kStudyGood : kStudyBad);
  const double thickness = radius * 0.18;
  if (good) {
    drawTick(canvas, center, radius, kStudyInk, thickness);
    return;
  }
  const double arm = radius * 0.38;
  for (const double side : {-1.0, 1.0}) {
    const std::array bar{center + arm * glm::dvec2(-side, -1), center + arm * glm::dvec2(side, 1)};
    canvas.line(bar, kStudyInk, thickness);
  }
}

void drawPauseSign(StudyCanvas& canvas, const glm::dvec2& center, double size, GuiColor color) {
  for (const double side : {-0.42, 0.14}) {
    canvas.fill({center.x + side * size, center.y - size / 2, 0.28 * size, size}, color, 0.06 * size);
  }
}

void drawFocusRing(StudyCanvas& canvas, const PixelRect& place, double rounding) {
  const double gap = canvas.length(5);
  canvas.outline({place.left - gap, place.top - gap, place.width + 2 * gap, place.height + 2 * gap}, kStudyAccent,
                 canvas.length(3), rounding + gap);
}

PixelRect drawFooter(StudyCanvas& canvas) {
  const double height = canvas.length(92);
  const PixelRect strip{0, canvas.height() - height, static_cast<double>(canvas.width()), height};
  canvas.fill(strip, kStudyCard);
  canvas.fill({0, strip.top, strip.width, std::max(1.0, canvas.length(1))}, kStudyField);
  const double middle = strip.center().y;
  const double x = drawKeyCap(canvas, canvas.length(36), middle, kUnwellKey, kStudyCard);
  canvas.writeLine({StudyText::kSmall, kStudyTextDim, kStudyCard},
                   {x + canvas.length(12), middle - canvas.look().textPixels(StudyText::kSmall) / 2},
                   canvas.texts().say("unwell_hint"));
  return strip;
}

double unwellWidth(const StudyCanvas& canvas) {
  return canvas.length(36 + 12) + keyCapWidth(canvas, kUnwellKey) +
         canvas.widthOf(canvas.texts().say("unwell_hint"), StudyText::kSmall);
}

std::vector<PageChoice> pageChoices(const std::string& action) {
  std::vector<PageChoice> choices;
  for (size_t from = action.find_first_not_of(' '); from != std::string::npos;) {
    const size_t end = std::min(action.find("  ", from), action.size());
    const std::string one = action.substr(from, end - from);
    const size_t colon = one.find(": ");
    PageChoice choice{colon == std::string::npos ? std::nullopt : keyFromName(one.substr(0, colon)), one};
    if (choice.key) {
      choice.label = one.substr(colon + 2);
    }
    choice.label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(choice.label[0])));
    choices.push_back(std::move(choice));
    from = action.find_first_not_of(' ', end);
  }
  return choices;
}

}  // namespace ocelli
