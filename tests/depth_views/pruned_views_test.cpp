#include "bench/pruned_views.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/depth_views/test_views.h"

namespace ocelli {
namespace {

Mesh boardBeforeWall(const glm::vec3& wallColor) {
  Mesh scene;
  test::addWall(scene, -0.9f, 0.8f, wallColor);
  test::addWall(scene, 0.5f, 0.4f, {0.8f, 0.8f, 0.8f});
  return scene;
}

// All of it is in the first view: nothing is left of the others, but for what rims let through of 2 pixels' erosion.
TEST(PrunedViews, whatAnEarlierViewShowsGoes) {
  const std::vector<DepthView> views = test::cornerViews(test::wall(0, 0.7f), 4);
  const PrunedViews pruned = pruneViews(views);
  EXPECT_EQ(pruned.samples, views[0].image.sampleCount());
  EXPECT_EQ(pruned.images[3].sampleCount(), 0u);
}

// Large enough that what the board hides is wider than the 4 pixels that erosion takes.
TEST(PrunedViews, whatWasHiddenStays) {
  const std::vector<DepthView> views =
      test::cornerViews(boardBeforeWall({0.1f, 0.1f, 0.1f}), 4, PinholeCamera(View{}, 360, 240));
  const PrunedViews pruned = pruneViews(views);
  EXPECT_GT(pruned.samples, views[0].image.sampleCount());
  EXPECT_LT(pruned.samples, 3 * views[0].image.sampleCount());
}

TEST(PrunedViews, anotherLumaOrDepthStays) {
  std::vector<DepthView> views = test::cornerViews(test::wall(0, 0.7f), 4);
  views.resize(2);
  const auto keptOfSecond = [&](const PruningRule& rule) { return pruneViews(views, rule).images[1].sampleCount(); };
  ReferenceImage& second = views[1].image;
  const size_t samples = second.sampleCount();
  EXPECT_EQ(keptOfSecond({}), 0u);
  const Image<glm::vec3> colors = second.color;
  std::fill(second.color.begin(), second.color.end(), glm::vec3(0.9f));
  EXPECT_EQ(keptOfSecond({}), samples);
  EXPECT_EQ(keptOfSecond({.lumaTolerance = 1}), 0u);
  second.color = colors;
  for (float& t : second.t) {
    t *= 1.2f;
  }
  EXPECT_EQ(keptOfSecond({}), samples);
  EXPECT_EQ(keptOfSecond({.depthTolerance = 0.3f}), 0u);
}

TEST(PrunedViews, whatIsPackedIsAtLeastWhatIsKept) {
  const PrunedViews pruned = pruneViews(test::cornerViews(boardBeforeWall({0.1f, 0.1f, 0.1f}), 4));
  EXPECT_GE(pruned.packedPixels, pruned.samples);
}

}  // namespace
}  // namespace ocelli
