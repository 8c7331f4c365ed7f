#include "study/screen/trial_painter.h"

#include <gtest/gtest.h>

#include "study/screen/study_painter.h"
#include "study/task/trial_image.h"
#include "tests/gl/gl_test_context.h"
#include "tests/study_screen/sample_screens.h"

namespace ocelli {
namespace {

constexpr TrialScreen kPaintScreen{1024, 640, 60};

class TrialPainterTest : public testing::TestWithParam<GlProvider> {
 protected:
  std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
  test::SampleStudy study_;
};
INSTANTIATE_TEST_SUITE_P(Providers, TrialPainterTest, kOffscreenProviders, providerName);

TEST_P(TrialPainterTest, rendersWhatASubjectSees) {
  TrialPainter painter(*context_, kPaintScreen);
  StudyPainter onScreen(*context_, kPaintScreen, Controls{});
  for (const TrialView view : kViews) {
    const TrialScreenView trial = study_.finding(kPaintScreen, view);
    const Image<Rgb8> image = painter.render(trial.layout);
    const GlScope scope(*context_);
    onScreen.draw(trial);
    EXPECT_EQ(image, onScreen.image());
    EXPECT_EQ(renderTrialImage(*context_, trial.layout, kPaintScreen), image);
  }
}

TEST_P(TrialPainterTest, hashesAreOfTheViewsAlone) {
  TrialPainter painter(*context_, kPaintScreen);
  StudyPainter onScreen(*context_, kPaintScreen, Controls{});
  const GlScope scope(*context_);
  TrialScreenView trial = study_.finding(kPaintScreen, TrialView::kOther, true);
  const StudyFrame frame = onScreen.draw(trial, 0.01, true);
  ASSERT_TRUE(frame.pixelHash);
  EXPECT_EQ(*frame.pixelHash, pixelHashOf(painter.renderViews(trial.layout)));
  EXPECT_FALSE(onScreen.draw(trial, 0.01, false).pixelHash);

  trial.layout.prompt = "Another prompt";
  trial.layout.pointer.reset();
  trial.showsPatch = false;
  EXPECT_EQ(onScreen.draw(trial, 0.01, true).pixelHash, frame.pixelHash);
  trial.layout.objectOffsets = {{0.01f, 0, 0}};
  EXPECT_NE(onScreen.draw(trial, 0.01, true).pixelHash, frame.pixelHash);
}

TEST_P(TrialPainterTest, thePatchIsInTheCornerAlone) {
  StudyPainter painter(*context_, kPaintScreen, Controls{});
  const GlScope scope(*context_);
  TrialScreenView trial = study_.finding(kPaintScreen, TrialView::kReference);
  painter.draw(trial);
  const Image<Rgb8> without = painter.image();
  for (const bool white : {true, false}) {
    trial.showsPatch = true;
    trial.patchWhite = white;
    painter.draw(trial);
    const Image<Rgb8> with = painter.image();
    int size = 0;
    while (size < kPaintScreen.width && with(size, kPaintScreen.height - 1) == Rgb8(white ? 255 : 0)) {
      ++size;
    }
    EXPECT_GE(size, 40);
    EXPECT_LE(size, 80);
    for (int y = 0; y < kPaintScreen.height; ++y) {
      for (int x = 0; x < kPaintScreen.width; ++x) {
        const bool inside = x < size && y >= kPaintScreen.height - size;
        ASSERT_EQ(with(x, y), inside ? Rgb8(white ? 255 : 0) : without(x, y)) << x << " " << y;
      }
    }
  }
}

}  // namespace
}  // namespace ocelli
