#include "study/screen/calibration_drawing.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "oc_core/window/screen_target.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

class CalibrationDrawing : public testing::TestWithParam<std::string> {};

TEST_P(CalibrationDrawing, keepsItsTextsOnTheScreenApartAndLegible) {
  const std::unique_ptr<GlContext> context = openOffscreenContext();
  const GlScope scope(*context);
  const SubjectTexts texts(GetParam());
  for (const glm::ivec2 size : {glm::ivec2(1024, 640), glm::ivec2(1280, 800), glm::ivec2(1920, 1200)}) {
    for (const DistanceMeasure distance : kDistanceMeasures) {
      CalibrationSteps steps({.card = distance == DistanceMeasure::kStated, .distance = distance},
                             {size.x, size.y, 518, 600});
      ScreenTarget target(*context, size.x, size.y);
      StudyCanvas canvas(*context, size.x, size.y, {}, texts);
      steps.press(Key::k9, 0);
      steps.press(Key::kSpace, 0);
      target.clear(kStudyBackground);
      target.bind();
      canvas.begin(0.02);
      // Half a minute on, the disc has not vanished: the longest of the texts.
      drawCalibration(canvas, steps, 30);
      target.bind();
      canvas.end();
      if (const char* folder = std::getenv("OCELLI_TEST_IMAGES")) {
        writePng(std::string(folder) + "/" + GetParam() + "_calibration_" + nameOf(distance) + "_" +
                     std::to_string(size.x) + ".png",
                 target.read());
      }
      const std::vector<TextBox>& boxes = canvas.textBoxes();
      EXPECT_GE(boxes.size(), 4u);
      for (size_t i = 0; i < boxes.size(); ++i) {
        const PixelRect& a = boxes[i].place;
        EXPECT_GE(a.left, 0) << boxes[i].text;
        EXPECT_LE(a.right(), size.x) << boxes[i].text;
        EXPECT_GE(a.top, 0) << boxes[i].text;
        EXPECT_LE(a.bottom(), size.y) << boxes[i].text;
        EXPECT_GE(contrastRatio(boxes[i].color, boxes[i].background), kMinContrast) << boxes[i].text;
        for (size_t j = 0; j < i; ++j) {
          const PixelRect& b = boxes[j].place;
          const bool apart = a.left >= b.right() || b.left >= a.right() || a.top >= b.bottom() || b.top >= a.bottom();
          EXPECT_TRUE(apart) << boxes[i].text << " and " << boxes[j].text;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, CalibrationDrawing, testing::Values("en", "de", "fr", "ja", "ar"),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace ocelli
