#include "display_sim/quilt/color_and_depth.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

const QuiltDisplay kTiny{"tiny", 3, 1, 240, 100, 0.8, 30};

TEST(ColorAndDepth, depthsRunFromWhiteForTheNearestToBlackForNothing) {
  const QuiltViews views(kTiny, View{});
  const ReferenceImage middle = middleDepthImage(views, loadScene("builtin:teapot"));
  const ColorAndDepth pair = colorAndDepth(middle);
  float nearest = 1e9f;
  float farthest = 0;
  for (size_t i = 0; i < middle.t.size(); ++i) {
    EXPECT_EQ(pair.depth[i] > 0, middle.holds(i));
    if (middle.holds(i)) {
      nearest = std::min(nearest, middle.t[i]);
      farthest = std::max(farthest, middle.t[i]);
    }
  }
  ASSERT_LT(nearest, farthest);
  for (size_t i = 0; i < middle.t.size(); ++i) {
    if (middle.holds(i)) {
      const float share = (1 / middle.t[i] - 1 / farthest) / (1 / nearest - 1 / farthest);
      EXPECT_NEAR(pair.depth[i], 1 + 254 * share, 0.51f);
    }
  }
}

TEST(ColorAndDepth, whatIsReadBackIsTheSameWithinAStep) {
  const QuiltViews views(kTiny, View{});
  const ReferenceImage middle = middleDepthImage(views, loadScene("builtin:teapot"));
  const ColorAndDepth pair = colorAndDepth(middle);
  const ReferenceImage back = depthImageOf(pair, views);
  const float step = (pair.nearInverseZ - pair.farInverseZ) / 254;
  for (size_t i = 0; i < middle.t.size(); ++i) {
    ASSERT_EQ(back.holds(i), middle.holds(i));
    if (middle.holds(i)) {
      EXPECT_NEAR(1 / back.t[i], 1 / middle.t[i], step * 0.51f);
    }
  }
  EXPECT_EQ(srgbFromLinear(back.color), pair.color);
}

TEST(ColorAndDepth, theDepthStandsWhereTheSideSays) {
  ColorAndDepth pair{Image<Rgb8>(2, 1, Rgb8(10, 20, 30)), Image<uint8_t>(2, 1, uint8_t{200})};
  const Rgb8 color(10, 20, 30);
  const Rgb8 depth(200);
  const auto at = [&](const char* name, int x, int y) {
    return pictureOf(pair, depthSideNamed(name, "--depth-side"))(x, y);
  };
  EXPECT_EQ(at("top", 0, 0), depth);
  EXPECT_EQ(at("top", 0, 1), color);
  EXPECT_EQ(at("bottom", 0, 1), depth);
  EXPECT_EQ(at("right", 1, 0), color);
  EXPECT_EQ(at("right", 2, 0), depth);
  EXPECT_EQ(at("left", 0, 0), depth);
  EXPECT_EQ(at("left", 2, 0), color);
  EXPECT_EQ(depthSideNamed("right", "").number, 2);
  EXPECT_THROW(depthSideNamed("behind", "--depth-side"), InputError);
}

}  // namespace
}  // namespace ocelli
