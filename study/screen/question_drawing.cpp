#include "study/screen/question_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "study/screen/study_pieces.h"

namespace ocelli {
namespace {

// Lengths at 1280 x 800.
constexpr double kOptionGap = 12;
constexpr double kEndsGap = 18;
constexpr double kTrackHeight = 46;
constexpr double kBoxPadding = 12;
constexpr double kNumberWidth = 220;
constexpr int kMaxTicks = 40;
constexpr int kTextLines = 2;  ///< of a box for sentences that is empty

double optionHeight(const StudyCanvas& canvas) {
  return canvas.look().textPixels(StudyText::kBody) + canvas.length(20);
}

/// Mark and label.
double optionWidth(const StudyCanvas& canvas, const std::string& label) {
  return canvas.length(14 + 20 + 10 + 18) + canvas.widthOf(label, StudyText::kBody);
}

double widestOption(const StudyCanvas& canvas, const QuestionLook& look) {
  double widest = 0;
  for (const QuestionLook::Option& option : look.options) {
    widest = std::max(widest, optionWidth(canvas, option.label));
  }
  return widest;
}

PixelRect shifted(const PixelRect& rect, const glm::dvec2& by) {
  return {rect.left + by.x, rect.top + by.y, rect.width, rect.height};
}

void drawRoundMark(StudyCanvas& canvas, const glm::dvec2& at, bool chosen) {
  canvas.ring(at, canvas.length(10), chosen ? kStudyAccent : kStudyTextDim, canvas.length(2));
  if (chosen) {
    canvas.disc(at, canvas.length(5.5), kStudyAccent);
  }
}

void drawSquareMark(StudyCanvas& canvas, const glm::dvec2& at, bool chosen) {
  const double half = canvas.length(9);
  canvas.outline({at.x - half, at.y - half, 2 * half, 2 * half}, chosen ? kStudyAccent : kStudyTextDim,
                 canvas.length(2), canvas.length(3));
  if (chosen) {
    drawTick(canvas, at, canvas.length(13), kStudyAccent, canvas.length(3));
  }
}

bool drawOption(StudyCanvas& canvas, const std::string& name, const PixelRect& place,
                const QuestionLook::Option& option, bool several) {
  const Touch touch = canvas.touch(name, place);
  const double rounding = canvas.length(9);
  const GuiColor background = option.chosen ? kStudyAccentDeep : (touch.hovered ? kStudyFieldHovered : kStudyField);
  canvas.fill(place, background, rounding);
  const bool lit = option.chosen || option.underCursor;
  canvas.outline(place, lit ? kStudyAccent : kStudyLine,
                 canvas.length(option.underCursor ? 3
                               : lit              ? 2
                                                  : 1.5),
                 rounding);
  const glm::dvec2 mark(place.left + canvas.length(24), place.center().y);
  if (several) {
    drawSquareMark(canvas, mark, option.chosen);
  } else {
    drawRoundMark(canvas, mark, option.chosen);
  }
  const StudyText text = optionWidth(canvas, option.label) > place.width + 1 ? StudyText::kSmall : StudyText::kBody;
  canvas.writeLine({text, kStudyText, background},
                   {place.left + canvas.length(44), mark.y - canvas.look().textPixels(text) / 2}, option.label);
  return touch.clicked;
}

}  // namespace

double optionsWidth(const StudyCanvas& canvas, const QuestionLook& look) {
  const auto count = static_cast<double>(look.options.size());
  return count * widestOption(canvas, look) + (count - 1) * canvas.length(kOptionGap);
}

QuestionPlaces::QuestionPlaces(const StudyCanvas& canvas, const QuestionLook& look, double width, bool inColumns)
    : width_(width) {
  if (!look.options.empty() && (look.ends.size() != 2 || !placeOnScale(canvas, look, width))) {
    placeInRows(canvas, look, width, inColumns);
  }
  if (look.track) {
    placeTrack(canvas, look, width);
  }
  if (look.box) {
    placeBox(canvas, look, width);
  }
}

/// Options side by side between what the ends mean. False, and nothing is placed, where they do not fit on a line.
bool QuestionPlaces::placeOnScale(const StudyCanvas& canvas, const QuestionLook& look, double width) {
  const double gap = canvas.length(kOptionGap);
  const double widest = widestOption(canvas, look);
  const double left = canvas.widthOf(look.ends[0], StudyText::kBody) + canvas.length(kEndsGap);
  const double right = canvas.widthOf(look.ends[1], StudyText::kBody) + canvas.length(kEndsGap);
  if (left + optionsWidth(canvas, look) + right > width) {
    return false;
  }
  for (size_t i = 0; i < look.options.size(); ++i) {
    options_.push_back({left + static_cast<double>(i) * (widest + gap), 0, widest, optionHeight(canvas)});
  }
  height_ = optionHeight(canvas);
  isScale_ = true;
  return true;
}

/// In rows, from the left.
void QuestionPlaces::placeInRows(const StudyCanvas& canvas, const QuestionLook& look, double width, bool inColumns) {
  const double gap = canvas.length(kOptionGap);
  const double height = optionHeight(canvas);
  const double widest = widestOption(canvas, look);
  double x = 0;
  double y = 0;
  for (const QuestionLook::Option& option : look.options) {
    const double own = std::min(inColumns ? widest : optionWidth(canvas, option.label), width);
    if (x > 0 && x + own > width + 0.5) {  // to rounding
      x = 0;
      y += height + gap;
    }
    options_.push_back({x, y, own, height});
    x += own + gap;
  }
  height_ = y + height;
  if (look.ends.size() == 2) {
    endsTop_ = height_ + canvas.length(6);
    height_ = *endsTop_ + canvas.lineHeight(StudyText::kSmall);
  }
}

void QuestionPlaces::placeTrack(const StudyCanvas& canvas, const QuestionLook& /*look*/, double width) {
  const double margin = canvas.length(16);
  track_ = {margin, 0, width - 2 * margin, canvas.length(kTrackHeight)};
  endsTop_ = track_.height + canvas.length(2);
  height_ = *endsTop_ + canvas.lineHeight(StudyText::kSmall);
}

void QuestionPlaces::placeBox(const StudyCanvas& canvas, const QuestionLook& look, double width) {
  const double pad = canvas.length(kBoxPadding);
  const double line = canvas.lineHeight(StudyText::kBody);
  if (look.box->isWide) {
    const double text = canvas.heightOf(look.box->text, StudyText::kBody, width - 2 * pad - canvas.length(6));
    box_ = {0, 0, width, std::max(kTextLines * line, text) + 2 * pad};
  } else {
    const double text = canvas.widthOf(look.box->text, StudyText::kBody) + 2 * pad + canvas.length(8);
    box_ = {0, 0, std::min(width, std::max(canvas.length(kNumberWidth), text)), line + 2 * pad};
  }
  height_ = box_.height;
}

void QuestionPlaces::drawEnds(StudyCanvas& canvas, const QuestionLook& look, const glm::dvec2& at) const {
  if (look.ends.size() != 2) {
    return;
  }
  if (isScale_) {
    const double y = at.y + (optionHeight(canvas) - canvas.look().textPixels(StudyText::kBody)) / 2;
    const Ink ink{StudyText::kBody, kStudyTextDim, kStudyCard};
    canvas.writeLine(ink, {at.x, y}, look.ends[0]);
    canvas.writeLine(ink, {at.x + options_.back().right() + canvas.length(kEndsGap), y}, look.ends[1]);
  } else if (endsTop_) {
    canvas.writeLine({StudyText::kSmall, kStudyTextDim, kStudyCard}, {at.x, at.y + *endsTop_}, look.ends[0]);
    canvas.writeLine({StudyText::kSmall, kStudyTextDim, kStudyCard, TextAlign::kRight},
                     {at.x + width_, at.y + *endsTop_}, look.ends[1]);
  }
}

std::optional<QuestionClick> QuestionPlaces::draw(StudyCanvas& canvas, const QuestionLook& look,
                                                  const std::string& name, const glm::dvec2& at) const {
  std::optional<QuestionClick> click;
  for (size_t i = 0; i < options_.size(); ++i) {
    if (drawOption(canvas, fmt::format("{} {}", name, i), shifted(options_[i], at), look.options[i],
                   look.severalOptions)) {
      click = QuestionClick{static_cast<int>(i)};
    }
  }
  drawEnds(canvas, look, at);
  if (look.track) {
    const PixelRect place = shifted(track_, at);
    const Touch touch = canvas.touch(name, place);
    const double middle = place.center().y;
    const double thickness = canvas.length(6);
    canvas.fill({place.left, middle - thickness / 2, place.width, thickness}, kStudyLine, thickness / 2);
    const int ticks = look.track->steps <= kMaxTicks ? look.track->steps : 2;
    for (int i = 0; i <= ticks; ++i) {
      const double x = place.left + place.width * i / ticks;
      const double half = canvas.length(2 * i == ticks || i == 0 || i == ticks ? 15 : 9);
      const std::array tick{glm::dvec2(x, middle - half), glm::dvec2(x, middle + half)};
      canvas.line(tick, kStudyLine, canvas.length(2));
    }
    if (look.track->share) {
      const glm::dvec2 mark(place.left + place.width * *look.track->share, middle);
      canvas.disc(mark, canvas.length(13), kStudyAccent);
      canvas.ring(mark, canvas.length(13), kStudyInk, canvas.length(2));
    }
    if (touch.held || touch.clicked) {
      click = QuestionClick{-1, touch.share};
    }
  }
  if (look.box) {
    const PixelRect place = shifted(box_, at);
    const Touch touch = canvas.touch(name, place);
    const double pad = canvas.length(kBoxPadding);
    canvas.fill(place, kStudyField, canvas.length(9));
    canvas.outline(place, kStudyLine, canvas.length(1.5), canvas.length(9));
    // A line that stands behind what has been typed, as texts do not scroll.
    canvas.write({StudyText::kBody, kStudyText, kStudyField},
                 {place.left + pad, place.top + pad, place.width - 2 * pad - canvas.length(6), 0}, look.box->text);
    if (!look.box->unit.empty()) {
      canvas.writeLine(
          {StudyText::kBody, kStudyTextDim, kStudyCard},
          {place.right() + canvas.length(12), place.center().y - canvas.look().textPixels(StudyText::kBody) / 2},
          look.box->unit);
    }
    if (touch.clicked) {
      click = QuestionClick{};
    }
  }
  return click;
}

}  // namespace ocelli
