#include "bench/pruned_views.h"

#include <gtest/gtest.h>

#include "oc_core/ocri/corner_depth_images.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

std::vector<DepthView> viewsOf(const Mesh& scene) {
  std::vector<DepthView> views;
  for (ReferenceImage& image : buildCornerDepthImages(test::smallCamera(), scene, ViewCell{}, 4)) {
    views.push_back({"v" + std::to_string(views.size()), std::move(image)});
  }
  return views;
}

Mesh boardBeforeWall(const glm::vec3& wallColor) {
  Mesh scene;
  test::addWall(scene, -0.9f, 0.8f, wallColor);
  test::addWall(scene, 0.5f, 0.4f, {0.8f, 0.8f, 0.8f});
  return scene;
}

// All of it is in the first view: nothing is left of the others, but for what rims let through of 2 pixels' erosion.
TEST(PrunedViews, whatAnEarlierViewShowsGoes) {
  const std::vector<DepthView> views = viewsOf(test::wall(0, 0.7f));
  const PrunedViews pruned = pruneViews(views);
  EXPECT_EQ(pruned.samples, views[0].image.sampleCount());
  EXPECT_EQ(pruned.images[3].sampleCount(), 0u);
}

TEST(PrunedViews, whatWasHiddenStays) {
  const std::vector<DepthView> views = viewsOf(boardBeforeWall({0.1f, 0.1f, 0.1f}));
  const PrunedViews pruned = pruneViews(views);
  EXPECT_GT(pruned.samples, views[0].image.sampleCount());
  EXPECT_LT(pruned.samples, 3 * views[0].image.sampleCount());
}

// The wall is within 10 % of the depth of the board: a rule that does not look at colours takes one for the other.
TEST(PrunedViews, nearDepthsNeedTheirLuma) {
  const std::vector<DepthView> views = viewsOf(boardBeforeWall({0.1f, 0.1f, 0.1f}));
  PruningRule loose;
  loose.depthTolerance = 0.2f;
  PruningRule blind = loose;
  blind.lumaTolerance = 1;
  EXPECT_GT(pruneViews(views, loose).samples, pruneViews(views, blind).samples);
}

TEST(PrunedViews, whatIsPackedIsAtLeastWhatIsKept) {
  const PrunedViews pruned = pruneViews(viewsOf(boardBeforeWall({0.1f, 0.1f, 0.1f})));
  EXPECT_GE(pruned.packedPixels, pruned.samples);
}

}  // namespace
}  // namespace ocelli
