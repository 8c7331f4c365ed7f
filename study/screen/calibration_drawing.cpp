#include "study/screen/calibration_drawing.h"

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/window/screen_target.h"
#include "study/screen/frame_measurement.h"
#include "study/screen/study_pieces.h"
#include "study/screen/window_input.h"

namespace ocelli {
namespace {

constexpr double kCalibrationTextWidth = 920;  // at 1280 x 800, as all lengths here

/// Title and text at the top, by their ids in the catalogues. Returns the lower end.
double writeHead(StudyCanvas& canvas, std::string_view title, std::string_view text) {
  const double middle = canvas.width() / 2.0;
  double y = canvas.length(36);
  canvas.writeLine({StudyText::kTitle, kStudyText, kStudyBackground, TextAlign::kCenter}, {middle, y},
                   canvas.texts().say(title));
  y += canvas.lineHeight(StudyText::kTitle) + canvas.length(10);
  const double width = std::min(canvas.length(kCalibrationTextWidth), canvas.width() * 0.9);
  return canvas.write({StudyText::kBody, kStudyText, kStudyBackground, TextAlign::kCenter},
                      {middle - width / 2, y, width, 0}, canvas.texts().say(text));
}

/// The button of the footer: whether it was clicked.
bool drawGoOn(StudyCanvas& canvas, const ButtonLook& look) {
  const PixelRect footer = drawFooter(canvas);
  const double width = buttonWidth(canvas, look);
  const double height = canvas.length(58);
  return drawButton(canvas, "go on",
                    {footer.right() - canvas.length(36) - width, footer.center().y - height / 2, width, height}, look);
}

void drawCard(StudyCanvas& canvas, CalibrationSteps& steps) {
  const double head = writeHead(canvas, "calibration_size_title", "calibration_size");
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
  if (drawGoOn(canvas, {.label = canvas.texts().say("calibration_fits"), .key = "Enter"})) {
    steps.press(Key::kEnter, 0);
  }
}

void drawTape(StudyCanvas& canvas, CalibrationSteps& steps) {
  writeHead(canvas, "calibration_distance_title", "calibration_tape");
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
                     {field.center().x, field.bottom() + canvas.length(16)},
                     canvas.texts().say("calibration_tape_range", {{"least", std::to_string(kMinTapeMillimeters)},
                                                                   {"most", std::to_string(kMaxTapeMillimeters)}}));
  }
  if (drawGoOn(canvas, {.label = canvas.texts().say("go_on"), .key = "Enter", .enabled = steps.typedIsPossible()})) {
    steps.press(Key::kEnter, 0);
  }
}

void drawBlindSpot(StudyCanvas& canvas, CalibrationSteps& steps, double seconds) {
  writeHead(canvas, "calibration_distance_title", "calibration_blind_spot");
  // The blind spot of the left eye lies to the left, whatever way one writes.
  const bool wasMirrored = canvas.setMirrored(false);
  const glm::dvec2 cross = steps.cross();
  const double arm = canvas.length(14);
  const std::vector<glm::dvec2> across{{cross.x - arm, cross.y}, {cross.x + arm, cross.y}};
  const std::vector<glm::dvec2> down{{cross.x, cross.y - arm}, {cross.x, cross.y + arm}};
  canvas.line(across, kStudyText, canvas.length(3));
  canvas.line(down, kStudyText, canvas.length(3));
  if (const std::optional<glm::dvec2> disc = steps.disc(seconds); disc && !steps.ranOut(seconds)) {
    canvas.disc(*disc, canvas.length(9), kStudyBad);
  }
  canvas.setMirrored(wasMirrored);
  const std::string state =
      steps.ranOut(seconds) ? canvas.texts().say("calibration_again")
                            : canvas.texts().say("calibration_measured", {{"done", std::to_string(steps.measured())},
                                                                          {"total", std::to_string(steps.wanted())}});
  canvas.writeLine(
      {StudyText::kBody, steps.ranOut(seconds) ? kStudyBad : kStudyTextDim, kStudyBackground, TextAlign::kCenter},
      {canvas.width() / 2.0, canvas.height() * 0.75}, state);
  const bool moves = steps.disc(seconds) && !steps.ranOut(seconds);
  if (drawGoOn(canvas,
               {.label = canvas.texts().say(moves ? "calibration_vanished" : "calibration_start"), .key = "Space"})) {
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
                                 const SubjectTexts& texts, const std::function<bool()>& interrupted) {
  const GlScope scope(window.context());
  ScreenTarget target(window.context(), screen.width, screen.height);
  StudyCanvas canvas(window.context(), screen.width, screen.height, {}, texts);
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
