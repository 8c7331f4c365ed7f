#include "oc_core/feeds_editor/feed_footprint.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace ocelli {
namespace {

/// A camera 2 m above the floor that looks down by 45 degrees, with a view of 90 degrees upright: its lower border
/// looks straight down, its upper one is level.
TEST(FeedFootprint, isWhereRaysMeetTheFloor) {
  FeedSetup setup;
  Feed feed;
  feed.width = 200;
  feed.height = 200;
  feed.lens = {{100, 100}, {100, 100}};
  feed.pose = {{1, 2, 3}, {1, 1, 2}, {0, 1, 0}};
  setup.feeds = {feed};
  const auto outline = footprintOf(setup, 0);
  ASSERT_GE(outline.size(), 10u);
  const glm::dvec2 eye(1, 3);
  for (size_t i = 0; i < outline.size() / 2; ++i) {
    EXPECT_NEAR(glm::distance(outline[i], eye), kMaxFootprint, 1e-6) << "the upper border sees no floor";
  }
  const glm::dvec2 below = outline[outline.size() - outline.size() / 4 - 1];  // the middle of the lower border
  EXPECT_LT(glm::distance(below, eye), 1e-6);
  // The lower left corner looks down by as much as it looks to the left: 2 m to the left, which is -x.
  const glm::dvec2 corner = outline.back();
  EXPECT_NEAR(corner.x, 1 - 2 / std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(corner.y, 3, 1e-6);
}

}  // namespace
}  // namespace ocelli
