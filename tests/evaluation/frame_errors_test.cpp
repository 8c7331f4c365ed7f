#include "oc_core/evaluation/frame_errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;

TEST(RenderFrame, showsPointsAndColoursOnBlack) {
  const ViewFrame frame = renderFrame(smallCamera(), test::wall(0, 0.5f));
  EXPECT_EQ(frame.points(45, 30).w, 1);
  EXPECT_NEAR(frame.points(45, 30).z, 0, 1e-5f);
  EXPECT_EQ(frame.image(45, 30), Rgb8(188)) << "a linear half";
  EXPECT_EQ(frame.points(0, 0).w, 0);
  EXPECT_EQ(frame.image(0, 0), Rgb8(0));
}

TEST(FrameErrors, ofEqualFramesAreNone) {
  const Mesh mesh = test::boxBeforeWall(0.9f);
  const ViewFrame frame = renderFrame(smallCamera(), mesh);
  const FrameComparison comparison = compareViewFrames(smallCamera(), frame, frame, RayScene(mesh));
  FrameErrors errors = countErrors(comparison, frame);
  addImageErrors(errors, frame, frame);
  EXPECT_GT(errors.truth, 1000u);
  EXPECT_EQ(errors.frame, errors.truth);
  EXPECT_EQ(errors.strict + errors.thick + errors.wrongFront + errors.falseSkin, 0u);
  EXPECT_EQ(errors.images, 1u);
  EXPECT_TRUE(std::isinf(errors.meanPsnrDecibels()));
  EXPECT_NEAR(errors.meanSsim(), 1, 1e-6);
  EXPECT_EQ(errors.meanFlip(), 0);
}

TEST(FrameErrors, addUpAndHaveRatios) {
  FrameErrors errors;
  errors.truth = 100;
  errors.strict = 10;
  errors.wrongFront = 4;
  errors.frame = 50;
  errors.falseSkin = 5;
  errors.images = 1;
  errors.squaredError = 0.03;
  errors.ssim = 0.5;
  errors.flip = 0.25;
  FrameErrors other;
  other.truth = 300;
  other.strict = 10;
  other.frame = 150;
  other.falseSkin = 1;
  other.images = 2;
  other.squaredError = 0;
  other.ssim = 2;
  other.flip = 0.05;
  errors += other;
  EXPECT_DOUBLE_EQ(errors.strictRatio(), 0.05);
  EXPECT_DOUBLE_EQ(errors.wrongFrontRatio(), 0.01);
  EXPECT_DOUBLE_EQ(errors.falseSkinRatio(), 0.03);
  EXPECT_DOUBLE_EQ(errors.meanPsnrDecibels(), 20) << "of the mean error, 0.01";
  EXPECT_DOUBLE_EQ(errors.meanSsim(), 2.5 / 3);
  EXPECT_DOUBLE_EQ(errors.meanFlip(), 0.1);
}

TEST(FrameErrors, ofNothingAreZero) {
  const FrameErrors none;
  EXPECT_EQ(none.strictRatio(), 0);
  EXPECT_EQ(none.wrongFrontRatio(), 0);
  EXPECT_EQ(none.falseSkinRatio(), 0);
  EXPECT_EQ(none.meanPsnrDecibels(), 0);
  EXPECT_EQ(none.meanSsim(), 0);
}

}  // namespace
}  // namespace ocelli
