#include "study/screen/calibration_drawing.h"

#include <fmt/format.h>

#include "oc_core/base/error.h"
#include "study/screen/frame_measurement.h"
#include "study/screen/screen_target.h"
#include "study/screen/study_pieces.h"
#include "study/screen/window_input.h"

namespace ocelli {
namespace {

constexpr double kCalibrationTextWidth = 920;  // at 1280 x 800, as all lengths here

/// Title and text at the top. Returns the lower end.
double writeHead(StudyCanvas& canvas, const std::string& title, const std::string& text) {
  const double middle = canvas.width() / 2.0;
  double y = canvas.length(36);
  canvas.writeLine({StudyText::kTitle, kStudyText, kStudyBackground, TextAlign::kCenter}, {middle, y}, title);
  y += canvas.lineHeight(StudyText::kTitle) + canvas.length(10);
  const double width = std::min(canvas.length(kCalibrationTextWidth), canvas.width() * 0.9);
  return canvas.write({StudyText::kBody, kStudyText, kStudyBackground, TextAlign::kCenter},
                      {middle - width / 2, y, width, 0}, text);
}

/// A button in the middle of the footer, or nothing clicked where it is not enabled.
bool drawGoOn(StudyCanvas& canvas, const ButtonLook& look) {
  const PixelRect footer = drawFooter(canvas);
  const double width = buttonWidth(canvas, look);
  const double height = canvas.length(58);
  return drawButton(canvas, "go on",
                    {footer.right() - canvas.length(36) - width, footer.center().y - height / 2, width, height}, look);
}

void drawCard(StudyCanvas& canvas, CalibrationSteps& steps) {
  const double head =
      writeHead(canvas, "How large is this screen?",
                "Hold a bank card, or any card of that size, flat against the screen, over the frame. Make "
                "the frame as wide as the card: Left and Right by one pixel, Up and Down by ten.");
  const glm::dvec2 size = steps.cardPixels();
  const double footer = canvas.height() - canvas.length(100);
  const glm::dvec2 middle(canvas.width() / 2.0, std::max((head + footer) / 2, head + size.y / 2 + canvas.length(10)));
  const PixelRect card{middle.x - size.x / 2, middle.y - size.y / 2, size.x, size.y};
  canvas.fill(card, kStudyCard, canvas.length(12));
  canvas.outline(card, kStudyAccent, 2, canvas.length(12));
  const double side = canvas.length(64);
  const double gap = canvas.length(24);
  if (drawButton(canvas, "narrower", {card.left - gap - side, middle.y - side / 2, side, side},
                 {.label = "-", .key = "", .primary = false})) {
    steps.widenCard(-1);
  }
  if (drawButton(canvas, "wider", {card.right() + gap, middle.y - side / 2, side, side},
                 {.label = "+", .key = "", .primary = false})) {
    steps.widenCard(1);
  }
  if (drawGoOn(canvas, {.label = "The card fits", .key = "Enter"})) {
    steps.press(Key::kEnter, 0);
  }
}

void drawTape(StudyCanvas& canvas, CalibrationSteps& steps) {
  writeHead(
      canvas, "How far is the eye from the screen?",
      "Sit as in the study. Measure from the eye to the middle of the screen with a tape, and type the millimetres.");
  const double middle = canvas.height() / 2.0;
  const double width = canvas.length(260);
  const PixelRect field{canvas.width() / 2.0 - width / 2, middle - canvas.length(40), width, canvas.length(80)};
  canvas.fill(field, kStudyField, canvas.length(8));
  canvas.outline(field, kStudyAccent, 2, canvas.length(8));
  canvas.writeLine({StudyText::kTitle, kStudyText, kStudyField, TextAlign::kCenter},
                   {field.center().x, field.center().y - canvas.look().textPixels(StudyText::kTitle) / 2},
                   (steps.typed().empty() ? "..." : steps.typed()) + " mm");
  if (!steps.typed().empty() && !steps.typedIsPossible()) {
    canvas.writeLine({StudyText::kBody, kStudyBad, kStudyBackground, TextAlign::kCenter},
                     {field.center().x, field.bottom() + canvas.length(16)}, "From 100 to 5000 mm");
  }
  if (drawGoOn(canvas, {.label = "Go on", .key = "Enter", .enabled = steps.typedIsPossible()})) {
    steps.press(Key::kEnter, 0);
  }
}

void drawBlindSpot(StudyCanvas& canvas, CalibrationSteps& steps, double seconds) {
  writeHead(
      canvas, "How far is the eye from the screen?",
      "Sit as in the study. Close the right eye and keep looking at the cross with the left one. Press Space: a disc "
      "moves to the left. Press Space again as soon as it vanishes.");
  const glm::dvec2 cross = steps.cross();
  const double arm = canvas.length(14);
  const std::vector<glm::dvec2> across{{cross.x - arm, cross.y}, {cross.x + arm, cross.y}};
  const std::vector<glm::dvec2> down{{cross.x, cross.y - arm}, {cross.x, cross.y + arm}};
  canvas.line(across, kStudyText, canvas.length(3));
  canvas.line(down, kStudyText, canvas.length(3));
  if (const std::optional<glm::dvec2> disc = steps.disc(seconds); disc && !steps.ranOut(seconds)) {
    canvas.disc(*disc, canvas.length(9), kStudyBad);
  }
  const std::string state = steps.ranOut(seconds)
                                ? "It did not vanish: look at the cross, and press Space to try again"
                                : fmt::format("Measured {} of {} times", steps.measured(), steps.wanted());
  canvas.writeLine(
      {StudyText::kBody, steps.ranOut(seconds) ? kStudyBad : kStudyTextDim, kStudyBackground, TextAlign::kCenter},
      {canvas.width() / 2.0, canvas.height() * 0.75}, state);
  const bool moves = steps.disc(seconds) && !steps.ranOut(seconds);
  if (drawGoOn(canvas, {.label = moves ? "It vanished" : "Start", .key = "Space"})) {
    steps.press(Key::kSpace, seconds);
  }
}

}  // namespace

void drawCalibration(StudyCanvas& canvas, CalibrationSteps& steps, double seconds) {
  switch (steps.step()) {
    case CalibrationSteps::Step::kCard:
      drawCard(canvas, steps);
      break;
    case CalibrationSteps::Step::kTape:
      drawTape(canvas, steps);
      break;
    case CalibrationSteps::Step::kBlindSpot:
      drawBlindSpot(canvas, steps, seconds);
      break;
    case CalibrationSteps::Step::kDone:
      break;
  }
}

ScreenCalibration runCalibration(GlWindow& window, const CalibrationWishes& wishes, const CalibratedScreen& screen,
                                 const std::function<bool()>& interrupted) {
  const GlScope scope(window.context());
  ScreenTarget target(window.context(), screen.width, screen.height);
  StudyCanvas canvas(window.context(), screen.width, screen.height);
  CalibrationSteps steps(wishes, screen);
  const auto secondsNow = [began = steadyNow()] { return static_cast<double>(steadyNow() - began) / 1e9; };
  const double pixelsPerUnit = window.size().pixelsPerUnit;
  double last = 0;
  bool stopped = false;
  while (steps.step() != CalibrationSteps::Step::kDone && !stopped) {
    for (const TimedWindowEvent& timed : window.pollTimed(0)) {
      stopped = stopped || std::holds_alternative<MonitorLostEvent>(timed.event);
      const auto* const event = std::get_if<InputEvent>(&timed.event);
      if (event == nullptr) {
        continue;
      }
      canvas.handle(inPixels(*event, pixelsPerUnit));
      if (const auto* key = std::get_if<KeyEvent>(event); key != nullptr && key->pressed) {
        stopped = stopped || key->key == Key::kEscape || key->key == Key::kF10;
        steps.press(key->key, secondsNow());
      }
      stopped = stopped || std::holds_alternative<CloseEvent>(*event);
    }
    stopped = stopped || (interrupted && interrupted());
    const double now = secondsNow();
    target.clear(kStudyBackground);
    target.bind();
    canvas.begin(now - last);
    last = now;
    drawCalibration(canvas, steps, now);
    target.bind();
    canvas.end();
    window.present(target.framebuffer(), screen.width, screen.height);
    window.awaitFrame();
  }
  if (stopped) {
    throw WorkError("the calibration was broken off", "calibration",
                    "start again; a protocol without \"calibration\" in \"screen\" measures nothing");
  }
  return steps.result();
}

}  // namespace ocelli
