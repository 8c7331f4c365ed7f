#include "oc_core/remote/remote_depth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ocelli {
namespace {

/// 2 to 8 in z, with a pixel that sees nothing.
Image<float> someDepths() {
  Image<float> t(5, 1);
  for (int x = 0; x < 4; ++x) {
    t(x, 0) = 2.0f + 2.0f * static_cast<float>(x);
  }
  return t;
}

TEST(RemoteDepth, IsLinearInTheInverse) {
  const RemoteDepth depth = roundedDepth(someDepths(), 4);
  EXPECT_DOUBLE_EQ(depth.inverseNear, 0.5);
  EXPECT_DOUBLE_EQ(depth.inverseFar, 0.125);
  // 1/z of 1/2, 1/4, 1/6, 1/8: 3, 1, 1/3 and 0 steps of an eighth above the farthest.
  EXPECT_EQ(depth.values(0, 0), 4);
  EXPECT_EQ(depth.values(1, 0), 2);
  EXPECT_EQ(depth.values(2, 0), 1);
  EXPECT_EQ(depth.values(3, 0), 1);
  EXPECT_EQ(depth.values(4, 0), 0);
  EXPECT_DOUBLE_EQ(depth.inverseDepth(2), 0.25);
}

TEST(RemoteDepth, NothingAndOneDepthAlone) {
  const RemoteDepth nothing = roundedDepth(Image<float>(3, 2), 100);
  EXPECT_EQ(nothing.values, Image<uint16_t>(3, 2));
  EXPECT_GT(nothing.inverseFar, 0);
  EXPECT_EQ(depthLevels(Image<float>(3, 2), 1000, 0.1, 0.1), RemoteDepth::kMinLevels);
  const RemoteDepth flat = roundedDepth(Image<float>(3, 2, 4.0f), 100);
  EXPECT_DOUBLE_EQ(flat.inverseDepth(flat.values[0]), 0.25);
}

TEST(RemoteDepth, LevelsKeepSamplesWithinTheError) {
  const Image<float> t = someDepths();
  constexpr double kFocal = 900;
  constexpr double kTranslation = 0.1;  // by 0.2, a tenth of the nearest
  for (const double error : {0.02, 0.1, 0.5}) {
    const RemoteDepth depth = roundedDepth(t, depthLevels(t, kFocal, kTranslation, error));
    EXPECT_LT(depth.levels, RemoteDepth::kMaxLevels);
    double worst = 0;
    for (size_t i = 0; i < 4; ++i) {
      const double off = depth.inverseDepth(depth.values[i]) - 1 / static_cast<double>(t[i]);
      worst = std::max(worst, std::abs(off) * kFocal * kTranslation * 2);
    }
    EXPECT_LE(worst, error * (1 + 1e-9));
    EXPECT_GT(worst, error / 20);  // no more levels than that takes, as far as three depths can tell
  }
}

}  // namespace
}  // namespace ocelli
