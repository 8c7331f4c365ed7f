#include "oc_core/ocri/square_corner.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

constexpr float kFocal = 500;
constexpr ImagePoint kSample{100, 50, 10};  // a footprint is 0.02

// Half a pixel along a surface whose 1/z changes by 0.001 there: 1 / 0.101 is 9.90099.
constexpr ImagePoint kStep{0.5f, 0.25f, 0.001f};

TEST(SquareCorner, liesOnTheSurface) {
  const ImagePoint corner = squareCorner(kSample, kStep, kFocal, {});
  EXPECT_FLOAT_EQ(corner.u, 100.5f);
  EXPECT_FLOAT_EQ(corner.v, 50.25f);
  EXPECT_NEAR(corner.t, 9.90099f, 1e-5);
}

TEST(SquareCorner, doesNotReachBehindTwiceTheDepth) {
  EXPECT_FLOAT_EQ(squareCorner(kSample, {0.5f, 0, -0.2f}, kFocal, {}).t, 20);
}

// 0.099 deep in full; two footprints are 0.04. What is left lies on the way to the corner, at the same slope of 1/z.
TEST(SquareCorner, isDrawnInWhereItWouldReachTooDeep) {
  const ImageMeshOptions options{.deepestSquareFootprints = 2};
  const ImagePoint corner = squareCorner(kSample, kStep, kFocal, options);
  const float part = (corner.u - 100) / kStep.u;
  EXPECT_NEAR(part, 0.04f / 0.09901f, 1e-3);
  EXPECT_FLOAT_EQ((corner.v - 50) / kStep.v, part);
  EXPECT_NEAR(1 / corner.t, 0.1f + part * 0.001f, 1e-6);
  // 1/z is shared out, and z with it but for as much as the corner is deep: a hundredth of z.
  EXPECT_NEAR(std::abs(corner.t - 10), 0.04f, 0.04f / 100);
  const ImagePoint flat = squareCorner(kSample, {0.5f, 0.25f, 0}, kFocal, options);
  EXPECT_FLOAT_EQ(flat.u, 100.5f);
  EXPECT_FLOAT_EQ(flat.t, 10);
}

}  // namespace
}  // namespace ocelli
