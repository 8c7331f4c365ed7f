// What trials show of their scenes, against the rasteriser on the CPU.
#include "study/screen/scene_views.h"

#include <gtest/gtest.h>

#include "oc_core/window/screen_target.h"
#include "study/task/trial_image.h"
#include "tests/gl/gl_test_context.h"
#include "tests/study_screen/sample_screens.h"

namespace ocelli {
namespace {

constexpr TrialScreen kViewScreen{480, 320, 60};

class SceneViewsTest : public testing::TestWithParam<GlProvider> {
 protected:
  Image<Rgb8> draw(SceneViews& views, const TrialLayout& layout) {
    const GlScope scope(*context_);
    ScreenTarget target(*context_, kViewScreen.width, kViewScreen.height);
    target.clear(kOkabeItoBlack);
    views.draw(layout, target.color());
    return target.read();
  }

  std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
  test::SampleStudy study_;
};
INSTANTIATE_TEST_SUITE_P(Providers, SceneViewsTest, kOffscreenProviders, providerName);

/// The pixels in which object `object` is seen, by the CPU.
Image<uint8_t> pixelsOf(const TrialLayout& layout, uint32_t object) {
  const TrialLayout::View& view = layout.views.front();
  const FragmentImage seen = rasterizeStudy(view.camera, meshOf(layout));
  Image<uint8_t> pixels(kViewScreen.width, kViewScreen.height, 0);
  for (int y = 0; y < seen.height(); ++y) {
    for (int x = 0; x < seen.width(); ++x) {
      const Fragment& fragment = seen(x, y);
      pixels(x + static_cast<int>(view.place.left), y + static_cast<int>(view.place.top)) =
          fragment.covered() && layout.scene->objectOfTriangle()[fragment.triangle] == object ? 1 : 0;
    }
  }
  return pixels;
}

TEST_P(SceneViewsTest, showsObjectsWhereTheCpuSeesThem) {
  SceneViews views(*context_);
  for (const TrialView kind : kViews) {
    TrialLayout layout = study_.finding(kViewScreen, kind).layout;
    const Image<Rgb8> image = draw(views, layout);
    size_t orange = 0;
    size_t wrong = 0;
    const Image<uint8_t> expected = pixelsOf(layout, 1);
    for (size_t i = 0; i < image.size(); ++i) {
      // Nothing else in the maze is orange: much more red than blue.
      const bool isOrange = image[i].x > image[i].z + 60;
      orange += expected[i];
      wrong += isOrange != (expected[i] == 1);
    }
    EXPECT_GT(orange, 500u);
    // Renderers differ at silhouettes alone, where a pixel's middle is within rounding of an edge: one in 200, as in
    // the tests of the renderer.
    EXPECT_LE(wrong, orange / 200) << defaultConditions().nameOf(kind);
  }
}

TEST_P(SceneViewsTest, colorsAreThoseOfTheCpu) {
  SceneViews views(*context_);
  const TrialLayout layout = study_.finding(kViewScreen, TrialView::kOther).layout;
  const Image<Rgb8> image = draw(views, layout);
  const Image<Rgb8> expected = viewsOf(layout, kViewScreen, rasterizeStudy);
  size_t different = 0;
  size_t compared = 0;
  const auto top = static_cast<int>(layout.views.front().place.top);
  for (int y = 0; y < kViewScreen.height; ++y) {
    for (int x = 0; x < kViewScreen.width; ++x) {
      if (y < top) {
        EXPECT_EQ(image(x, y), Rgb8(0)) << "nothing is drawn outside of the views";
        continue;
      }
      const glm::ivec3 step = glm::abs(glm::ivec3(image(x, y)) - glm::ivec3(expected(x, y)));
      ++compared;
      different += std::max({step.x, step.y, step.z}) > 2;  // rounding of weights and of the encoding
    }
  }
  EXPECT_GT(compared, 50000u);
  EXPECT_LE(different, compared / 200);
}

TEST_P(SceneViewsTest, movingObjectsAreAsUploadedAnew) {
  SceneViews views(*context_);
  for (const TrialView kind : kViews) {
    TrialLayout layout = study_.finding(kViewScreen, kind).layout;
    const Image<Rgb8> still = draw(views, layout);
    for (int step = 1; step <= 4; ++step) {
      const float by = 0.2f * static_cast<float>(step);
      layout.objectOffsets = {{by, 0, -by}, {-by, 0, by}};
      SceneViews fresh(*context_);
      const Image<Rgb8> moved = draw(views, layout);
      EXPECT_EQ(moved, draw(fresh, layout)) << step;
      EXPECT_NE(moved, still);
    }
    layout.objectOffsets = {};  // back where they stood
    EXPECT_EQ(draw(views, layout), still);
  }
}

TEST_P(SceneViewsTest, anotherSceneTakesThePlaceOfTheOneBefore) {
  SceneViews views(*context_);
  TrialLayout layout = study_.finding(kViewScreen, TrialView::kReference).layout;
  layout.objectOffsets = {{0.5f, 0, 0}, {0, 0, 0}};
  draw(views, layout);
  Maze maze = test::sampleMaze();
  maze.landmarks[0].color = LandmarkColor::kPurple;
  const StudyScene other(maze);
  layout.scene = &other;
  SceneViews fresh(*context_);
  EXPECT_EQ(draw(views, layout), draw(fresh, layout));
}

TEST_P(SceneViewsTest, portraitsShowOneObject) {
  const GlScope scope(*context_);
  SceneViews views(*context_);
  const GlObject& texture = views.portraitOf(study_.scene, 0, 64);
  using Rgba8 = std::array<uint8_t, 4>;
  constexpr uint32_t kRgba = 0x1908;          // GL_RGBA
  constexpr uint32_t kUnsignedByte = 0x1401;  // GL_UNSIGNED_BYTE
  const auto image = readTexture<Rgba8>(*context_, texture, 64, 64, kRgba, kUnsignedByte);
  const Rgba8 middle = image(32, 32);
  EXPECT_EQ(middle[3], 255);
  EXPECT_GT(middle[0], middle[2] + 60) << "the orange sphere";
  EXPECT_EQ(image(1, 1)[3], 0) << "with room around it";
}

}  // namespace
}  // namespace ocelli
