#include "oc_core/constructor/target_sight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/constructor/target_constructor.h"

namespace ocelli {
namespace {

using ::testing::HasSubstr;

/// From (0, 0, 10) along -z. 90 pixels at 60 degrees: focal length 77.94.
PinholeCamera sightView() {
  View view;
  view.eye = {0, 0, 10};
  view.target = {0, 0, 0};
  view.fovVerticalDegrees = 60;
  return {view, 160, 90};
}

constexpr double kFocal = 77.942286;

Box cubeAt(const glm::vec3& center, float half) {
  return {center - half, center + half};
}

const Box kSeen = cubeAt({0, 0, 0}, 0.5f);

double byImages(const std::vector<Box>& occluders, const TargetMargin& margin = {}) {
  return targetSight("images").share(CurvedRayCamera(sightView()), occluders, kSeen, margin);
}

double byRays(const std::vector<Box>& occluders, const TargetMargin& margin = {}) {
  return targetSight("rays").share(CurvedRayCamera(sightView()), occluders, kSeen, margin);
}

TEST(ImageOfBox, isTheRectangleAroundItsNearFace) {
  const auto image = imageOfBox(CurvedRayCamera(sightView()), kSeen);
  ASSERT_TRUE(image);
  const double half = kFocal * 0.5 / 9.5;  // the near face is 9.5 away
  EXPECT_NEAR(image->lower.x, 80 - half, 1e-3);
  EXPECT_NEAR(image->upper.x, 80 + half, 1e-3);
  EXPECT_NEAR(image->lower.y, 45 - half, 1e-3);
  EXPECT_NEAR(image->upper.y, 45 + half, 1e-3);
  EXPECT_NEAR(image->nearest, 9.5, 1e-5);
  EXPECT_TRUE(image->whole);
}

TEST(ImageOfBox, isNotWholeAtTheBorderAndIsNoneBehindTheEye) {
  const auto atBorder = imageOfBox(CurvedRayCamera(sightView()), cubeAt({10, 0, 0}, 0.5f));
  ASSERT_TRUE(atBorder);
  EXPECT_FALSE(atBorder->whole);
  EXPECT_FALSE(imageOfBox(CurvedRayCamera(sightView()), cubeAt({0, 0, 20}, 0.5f)));
}

TEST(ImageOfBox, followsRaysThatBend) {
  const CurvedRayCamera bent = bentCamera(sightView(), kSeen, 0.6);
  const auto image = imageOfBox(bent, kSeen);
  ASSERT_TRUE(image);
  const ImagePoint middle = *bent.project(kSeen.center());
  EXPECT_LT(image->lower.x, middle.u);
  EXPECT_GT(image->upper.x, middle.u);
  // The viewpoint is 3 aside: the image is not where the pinhole has it.
  EXPECT_GT(std::abs(middle.u - 80), 10);
}

TEST(TargetSight, imagesThatOverlapHideTheTarget) {
  EXPECT_EQ(byImages({}), 1);
  // The left half of the target's image, from 5 away: all of x < 0.
  const Box left{{-3, -3, 4.9f}, {0, 3, 5}};
  EXPECT_NEAR(byImages({left}), 0.5, 1e-6);
  EXPECT_EQ(byImages({{{-3, -3, 4.9f}, {3, 3, 5}}}), 0);
  // Twice the same hides no more; what is behind the target, nothing.
  EXPECT_NEAR(byImages({left, left}), 0.5, 1e-6);
  EXPECT_EQ(byImages({cubeAt({0, 0, -4}, 2)}), 1);
}

TEST(TargetSight, theTextsTestIsThatNoImagesMeet) {
  // The image of the target ends 4.102 pixels beside the middle; at 5 away that is 0.2632 aside.
  const float edge = static_cast<float>(0.5 / 9.5 * 5);
  const auto beside = [](float from) { return Box{{from, -3, 4.9f}, {from + 1, 3, 5}}; };
  EXPECT_EQ(byImages({beside(edge + 0.01f)}), 1);
  EXPECT_LT(byImages({beside(edge - 0.01f)}), 1);
  // 2 pixels at 5 away are 0.128.
  const TargetMargin twoPixels{0, 2};
  EXPECT_LT(byImages({beside(edge + 0.12f)}, twoPixels), 1);
  EXPECT_EQ(byImages({beside(edge + 0.14f)}, twoPixels), 1);
}

TEST(TargetSight, aTargetThatIsNotWhollyInTheImageIsNotShown) {
  EXPECT_EQ(targetSight("images").share(CurvedRayCamera(sightView()), {}, cubeAt({10, 0, 0}, 0.5f), {}), 0);
  EXPECT_EQ(targetSight("images").share(CurvedRayCamera(sightView()), {}, cubeAt({0, 0, 20}, 0.5f), {}), 0);
}

TEST(TargetSight, pixelsEnlargeTheBoxThatRaysReach) {
  // 4 of 4 columns of points of the target pass by what begins at x = 0.5, 5 away; enlarged by 4 pixels, that is by
  // 0.513 at 10 away, the outer columns of points stand at 0.76 and do not: they pass it at 0.38.
  const Box right{{0.36f, -3, 4.9f}, {3, 3, 5}};
  EXPECT_EQ(byRays({right}), 1);
  EXPECT_DOUBLE_EQ(byRays({right}, {0, 4}), 0.75);
}

TEST(TargetSight, unknownNamesAreRefused) {
  try {
    targetSight("smell");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("use rays or images"));
  }
}

TEST(TargetTracker, byImagesItClearsTheTargetByItsPixels) {
  TargetOptions options;
  options.sight = "images";
  options.visibleShare = 1;
  options.enlarged = 0;
  const std::vector<Box> before{{{-0.2f, -1, 3.8f}, {0.2f, 1, 4}}};
  double last = 0;
  for (const double pixels : {0.0, 2.0, 5.0}) {
    options.enlargedPixels = pixels;
    const double f = TargetTracker(options).wanted(sightView(), before, kSeen);
    ASSERT_NE(f, 0) << pixels;
    const CurvedRayCamera camera = bentCamera(sightView(), kSeen, f);
    const BoxImage target = *imageOfBox(camera, kSeen);
    const BoxImage occluder = *imageOfBox(camera, before[0]);
    const double gap = std::max(target.lower.x - occluder.upper.x, occluder.lower.x - target.upper.x);
    EXPECT_GE(gap, pixels);
    EXPECT_GE(std::abs(f), last);
    last = std::abs(f);
  }
}

TEST(TargetTracker, goesOnWhileAllMovesAndTheTargetPassesBehindTheEye) {
  for (const TargetSight& sight : targetSights()) {
    TargetOptions options;
    options.sight = sight.name;
    options.maxChange = 0.02;
    TargetTracker tracker(options);
    size_t bent = 0;
    for (int i = 0; i < 300; ++i) {
      const auto t = static_cast<float>(i) / 300;
      const Box target = cubeAt({std::sin(9 * t), 0, 25 * t - 5}, 0.5f);  // through the eye, and on behind it
      const std::vector<Box> others{cubeAt({0.5f - t, 0, 5 * t + 1}, 0.6f), cubeAt({t, 0, 8 * t - 2}, 0.4f)};
      const double before = tracker.f();
      bent += !tracker.update(sightView(), others, target).bends().empty();
      EXPECT_LE(std::abs(tracker.f() - before), 0.02 + 1e-12) << sight.name << i;
    }
    EXPECT_GT(bent, 20u) << sight.name;
    EXPECT_EQ(tracker.f(), 0) << sight.name;  // behind the eye since long
  }
}

}  // namespace
}  // namespace ocelli
