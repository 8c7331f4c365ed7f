#include "oc_core/depth_views/depth_levels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ocelli {
namespace {

TEST(DepthLevels, endsAreNearAndFar) {
  const DepthLevels inverse{&depthScales()[0], 2, 8};
  EXPECT_FLOAT_EQ(inverse.zOf(1), 8);
  EXPECT_FLOAT_EQ(inverse.zOf(kMaxDepthLevel), 2);
  const DepthLevels linear{&depthScales()[1], 2, 8};
  EXPECT_FLOAT_EQ(linear.zOf(1), 2);
  EXPECT_FLOAT_EQ(linear.zOf(kMaxDepthLevel), 8);
  for (const DepthLevels& levels : {inverse, linear}) {
    EXPECT_EQ(levels.zOf(0), 0);
    EXPECT_EQ(levels.levelOf(0), 0);
  }
}

// Equal steps of 1/z: half way between 1/2 and 1/8 is 5/16.
TEST(DepthLevels, theMiddleIsThatOfTheScale) {
  EXPECT_NEAR(DepthLevels({&depthScales()[0], 2, 8}).zOf(32768), 16.0f / 5, 1e-6);
  EXPECT_NEAR(DepthLevels({&depthScales()[1], 2, 8}).zOf(32768), 5, 1e-6);
}

// Depth cameras give millimetres.
TEST(DepthLevels, millimetresAreAScaleOfZ) {
  const DepthLevels levels{&depthScales()[1], 0.001f, 65.535f};
  for (const int millimetres : {1, 500, 4711, 65535}) {
    EXPECT_NEAR(levels.zOf(static_cast<uint16_t>(millimetres)), 1e-3 * millimetres, 1e-5);  // floats of up to 65
  }
}

TEST(DepthLevels, everyLevelComesBack) {
  for (const DepthScale& scale : depthScales()) {
    const DepthLevels levels{&scale, 0.5f, 3};
    for (int level = 0; level <= kMaxDepthLevel; level += 13) {
      EXPECT_EQ(levels.levelOf(levels.zOf(static_cast<uint16_t>(level))), level) << scale.name;
    }
  }
}

TEST(DepthLevels, depthsBeyondTheEndsAreTheEnds) {
  const DepthLevels levels{&depthScales()[0], 2, 8};
  EXPECT_EQ(levels.levelOf(1), kMaxDepthLevel);
  EXPECT_EQ(levels.levelOf(9), 1);
  EXPECT_EQ(levels.levelOf(std::nanf("")), 0);
}

}  // namespace
}  // namespace ocelli
