#include "study/screen/calibration_drawing.h"

#include <gtest/gtest.h>

#include "study/screen/screen_target.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

TEST(CalibrationDrawing, keepsItsTextsOnTheScreenAndLegible) {
  const std::unique_ptr<GlContext> context = openOffscreenContext();
  const GlScope scope(*context);
  for (const glm::ivec2 size : {glm::ivec2(1024, 640), glm::ivec2(1280, 800), glm::ivec2(1920, 1200)}) {
    for (const DistanceMeasure distance :
         {DistanceMeasure::kStated, DistanceMeasure::kTape, DistanceMeasure::kBlindSpot}) {
      CalibrationSteps steps({.card = distance == DistanceMeasure::kStated, .distance = distance},
                             {size.x, size.y, 518, 600});
      ScreenTarget target(*context, size.x, size.y);
      StudyCanvas canvas(*context, size.x, size.y);
      steps.press(Key::k9, 0);
      steps.press(Key::kSpace, 0);
      target.bind();
      canvas.begin(0.02);
      drawCalibration(canvas, steps, 500);
      target.bind();
      canvas.end();
      EXPECT_GE(canvas.textBoxes().size(), 4u);
      for (const TextBox& text : canvas.textBoxes()) {
        EXPECT_GE(text.place.left, 0) << text.text;
        EXPECT_LE(text.place.right(), size.x) << text.text;
        EXPECT_GE(text.place.top, 0) << text.text;
        EXPECT_LE(text.place.bottom(), size.y) << text.text;
        EXPECT_GE(contrastRatio(text.color, text.background), kMinContrast) << text.text;
      }
    }
  }
}

}  // namespace
}  // namespace ocelli
