#include "study/screen/estimate_drawing.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

/// Of the mark. Its shape says the same as its colour.
constexpr GuiColor kMark = kOkabeItoOrange;

void drawLine(StudyCanvas& canvas, const glm::dvec2& from, const glm::dvec2& to, GuiColor color, double thickness) {
  const std::array points{from, to};
  canvas.line(points, color, thickness);
}

}  // namespace

void drawScale(StudyCanvas& canvas, const TrialLayout::Scale& scale) {
  const PixelRect& place = scale.place;
  const double middle = place.top + place.height * 0.42;
  const double tick = canvas.length(9);
  const double range = scale.most - scale.least;
  const auto xOf = [&](double value) { return place.left + (value - scale.least) / range * place.width; };
  drawLine(canvas, {place.left, middle}, {place.right(), middle}, kStudyText, canvas.length(2.5));
  constexpr double kSlack = 1e-9;
  const int numbers = static_cast<int>(std::floor(range / scale.step + kSlack));
  for (int i = 0; i <= numbers; ++i) {
    const double value = scale.least + i * scale.step;
    const double x = xOf(value);
    drawLine(canvas, {x, middle - tick}, {x, middle + tick}, kStudyText, canvas.length(2));
    const std::string text = i == numbers ? fmt::format("{:g} {}", value, scale.unit) : fmt::format("{:g}", value);
    canvas.writeLine({StudyText::kSmall, kStudyText, kStudyBackground, TextAlign::kCenter},
                     {x, middle + tick + canvas.length(3)}, text);
    // Halves, without numbers.
    if (i < numbers) {
      const double half = xOf(value + scale.step / 2);
      drawLine(canvas, {half, middle - tick / 2}, {half, middle + tick / 2}, kStudyTextDim, canvas.length(1.5));
    }
  }
  if (scale.mark) {
    const double x = xOf(*scale.mark);
    const double size = canvas.length(11);
    drawLine(canvas, {x, middle - tick}, {x, middle + tick * 1.5}, kMark, canvas.length(4));
    canvas.triangle({x, middle - tick * 0.5}, {x - size, middle - tick - size * 1.2},
                    {x + size, middle - tick - size * 1.2}, kMark);
  }
}

void drawDial(StudyCanvas& canvas, const TrialLayout::Dial& dial) {
  constexpr int kTicks = 24;
  constexpr int kLongTicks = 6;  // every 90 degrees
  constexpr int kSides = 360;    // of the circle
  const glm::dvec2 center = dial.place.center();
  const double text = canvas.look().textPixels(StudyText::kSmall);
  // The word stands above the circle, where the arrow does not hide it.
  const double radius = dial.place.width / 2 - text - canvas.length(8);
  const auto wayTo = [](double angle) { return glm::dvec2(std::sin(angle), -std::cos(angle)); };
  canvas.disc(center, radius, kStudyCard);
  std::vector<glm::dvec2> circle;
  for (int i = 0; i <= kSides; ++i) {
    circle.push_back(center + radius * wayTo(2 * kPi * i / kSides));
  }
  canvas.line(circle, kStudyText, canvas.length(2.5));
  for (int i = 0; i < kTicks; ++i) {
    const glm::dvec2 way = wayTo(2 * kPi * i / kTicks);
    const bool isLong = i % kLongTicks == 0;
    drawLine(canvas, center + way * (radius - canvas.length(isLong ? 12 : 6)), center + way * radius,
             isLong ? kStudyText : kStudyTextDim, canvas.length(isLong ? 2.5 : 1.5));
  }
  canvas.writeLine({StudyText::kSmall, kStudyText, kStudyBackground, TextAlign::kCenter},
                   {center.x, center.y - radius - text - canvas.length(4)}, canvas.texts().say("ahead"));
  // The subject, who looks up.
  const double self = std::min(canvas.length(14), text);
  if (dial.degrees) {
    const glm::dvec2 way = wayTo(radiansFromDegrees(*dial.degrees));
    const glm::dvec2 side(-way.y, way.x);
    const double head = canvas.length(20);
    const glm::dvec2 tip = center + way * (radius - canvas.length(3));
    drawLine(canvas, center + way * self, tip - way * head * 0.8, kMark, canvas.length(5));
    canvas.triangle(tip, tip - way * head + side * head * 0.5, tip - way * head - side * head * 0.5, kMark);
  }
  canvas.triangle(center + glm::dvec2(0, -self), center + glm::dvec2(self * 0.75, self * 0.75),
                  center + glm::dvec2(-self * 0.75, self * 0.75), kStudyText);
}

}  // namespace ocelli
