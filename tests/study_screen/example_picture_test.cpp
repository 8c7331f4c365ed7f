#include "study/screen/example_picture.h"

#include <gtest/gtest.h>

#include "study/screen/study_painter.h"
#include "study/screen/trial_painter.h"
#include "tests/gl/gl_test_context.h"
#include "tests/study_screen/sample_screens.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

constexpr TrialScreen kPictureScreen{1024, 640, 60};

class ExamplePictureTest : public testing::Test {
 protected:
  std::unique_ptr<GlContext> context_ = openTestContext(GlProvider::kOsMesa);

  static std::shared_ptr<const PageExample> exampleOf(const std::string& name, TrialView view) {
    const test::TaskExample& task = test::taskExample(name);
    return std::make_shared<const PageExample>(
        PageExample{test::readBlock(task.task, task.json), test::planOf(task.task, 0, view)});
  }
};

TEST_F(ExamplePictureTest, isWhatTheTrialShowsPixelByPixel) {
  TrialPainter painter(*context_, kPictureScreen);
  for (const char* name : {"find", "count", "nearer"}) {
    for (const TrialView view : kViews) {
      SCOPED_TRACE(name);
      const auto example = exampleOf(name, view);
      const auto run = example->task->start(example->plan, kPictureScreen);
      const TrialLayout layout = run->layout();
      const Image<Rgb8> trial = painter.renderViews(layout);
      const GlScope scope(*context_);
      const ExamplePicture picture = examplePicture(*context_, *example, kPictureScreen);
      const auto left = static_cast<int>(layout.views.front().place.left);
      const auto top = static_cast<int>(layout.views.front().place.top);
      size_t compared = 0;
      for (const TrialLayout::View& each : layout.views) {
        for (int y = static_cast<int>(each.place.top); y < static_cast<int>(each.place.bottom()); ++y) {
          for (int x = static_cast<int>(each.place.left); x < static_cast<int>(each.place.right()); ++x) {
            ASSERT_EQ(picture.pixels(x - left, y - top), trial(x, y)) << x << ", " << y;
            ++compared;
          }
        }
      }
      EXPECT_GT(compared, picture.pixels.size() * 9 / 10);  // all but the gaps between views
    }
  }
}

TEST_F(ExamplePictureTest, ringsEveryObjectThatItShowsInEveryCondition) {
  const GlScope scope(*context_);
  for (const TrialView view : kViews) {
    const ExamplePicture picture = examplePicture(*context_, *exampleOf("nearer", view), kPictureScreen);
    ASSERT_EQ(picture.marks.size(), 2u);
    for (const ExamplePicture::Mark& mark : picture.marks) {
      EXPECT_GT(mark.radius, 3);
      // The orange object is in the middle: walls and floor are grey, the sky is blue.
      const Rgb8 middle = picture.pixels(static_cast<int>(mark.center.x), static_cast<int>(mark.center.y));
      EXPECT_GT(middle.x - middle.z, 60);
    }
  }
}

TEST_F(ExamplePictureTest, isRingedOnThePageInEveryCondition) {
  StudyPainter painter(*context_, kPictureScreen, Controls{});
  const GlScope scope(*context_);
  const test::SampleStudy study;
  for (const TrialView view : kViews) {
    PageScreen page = study.instructions("");
    page.example = exampleOf("nearer", view);
    painter.draw(page);
    const Image<Rgb8> image = painter.image();
    size_t white = 0;
    for (int y = 60; y < kPictureScreen.height * 3 / 4; ++y) {
      for (int x = kPictureScreen.width / 2; x < kPictureScreen.width; ++x) {
        white += image(x, y) == Rgb8(255) ? 1 : 0;
      }
    }
    EXPECT_GT(white, 50u);  // of two rings: nothing else on the right is white
  }
}

TEST(ExamplePicture, shrinksByTheMeanOfTheLight) {
  Image<Rgb8> image(4, 2, Rgb8(0));
  image(0, 0) = image(1, 1) = Rgb8(255);
  image(2, 0) = image(2, 1) = image(3, 0) = image(3, 1) = Rgb8(100, 0, 0);
  const Image<Rgb8> small = shrunk(image, 2, 1);
  EXPECT_EQ(small(0, 0), Rgb8(188));  // half of the light
  EXPECT_EQ(small(1, 0), Rgb8(100, 0, 0));
  EXPECT_EQ(shrunk(image, 4, 2), image);
}

}  // namespace
}  // namespace ocelli
