// Marks of gaze over a trial that is shown again.
#include <gtest/gtest.h>

#include "study/replay/gaze_trail.h"
#include "study/screen/study_painter.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

constexpr TrialScreen kGazeScreen{1280, 800, 60};

Image<Rgb8> drawnWith(GlContext& context, const std::vector<GazeMark>& marks, const SubjectTexts& texts) {
  StudyPainter painter(context, kGazeScreen, Controls{}, {}, texts);
  const GlScope scope(context);
  painter.draw(TrialScreenView{{}, false, false, marks});
  return painter.image();
}

TEST(GazeDrawing, isARingWithATrailAndNothingElse) {
  const std::unique_ptr<GlContext> context = openOffscreenContext();
  const Image<Rgb8> without = drawnWith(*context, {}, SubjectTexts());
  const Image<Rgb8> with = drawnWith(*context, {{{400, 300}, 0.9}, {{640, 400}, 0}}, SubjectTexts());
  const int right = 640 + static_cast<int>(kGazeRadius);
  EXPECT_GT(with(right, 400).x, 200) << "the ring";
  EXPECT_EQ(with(644, 404), without(644, 404)) << "what is looked at is seen";
  EXPECT_GT(with(520, 350).x, 150) << "the trail";
  int changed = 0;
  for (int y = 0; y < kGazeScreen.height; ++y) {
    for (int x = 0; x < kGazeScreen.width; ++x) {
      const bool differs = with(x, y) != without(x, y);
      changed += differs ? 1 : 0;
      if (differs) {
        ASSERT_TRUE(x > 385 && x < 670 && y > 285 && y < 430) << x << ", " << y;
      }
    }
  }
  EXPECT_GT(changed, 500);
}

}  // namespace
}  // namespace ocelli
