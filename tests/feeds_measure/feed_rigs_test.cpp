// The rigs of simulated feeds: each makes one continuous image, in which people walk where nothing stands.
#include "oc_core/feeds_measure/feed_rigs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/feeds/feed_map.h"
#include "oc_core/feeds_measure/simulated_feed.h"
#include "oc_core/scene/box.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

Mesh coarsePlaceOf(const FeedRig& rig) {
  SceneOptions options;
  options.fit = false;
  options.shading = Shading::kNone;
  return loadScene(std::string("builtin:") + rig.scene + ",texel=0.15", options);
}

class EveryFeedRig : public testing::TestWithParam<size_t> {
 protected:
  static const FeedRig& rig() { return feedRigs()[GetParam()]; }
};

TEST_P(EveryFeedRig, FeedsFillTheImage) {
  const FeedGraph graph(rig().setup());
  const FeedMap map(graph);
  for (size_t i = 0; i < graph.frusta(); ++i) {
    // Lenses of cameras that are simulated see a little less or more at their borders.
    EXPECT_GT(map.coverage(i), 0.995) << graph.feedOf(i).name;
  }
}

/// How near points of a triangle between ankles and heads come to a rectangle of the floor, seen from above.
double distanceTo(const std::array<glm::dvec3, 3>& corners, const glm::dvec2& lower, const glm::dvec2& upper) {
  constexpr double kStep = 0.05;
  double nearest = 1e9;
  const double side = std::max(glm::distance(corners[0], corners[1]), glm::distance(corners[0], corners[2]));
  const int steps = std::max(1, static_cast<int>(std::ceil(side / kStep)));
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const glm::dvec3 p = corners[0] + (corners[1] - corners[0]) * (static_cast<double>(i) / steps) +
                           (corners[2] - corners[0]) * (static_cast<double>(j) / steps);
      if (p.y > 0.1 && p.y < 1.9) {
        const glm::dvec2 q(p.x, p.z);
        nearest = std::min(nearest, glm::distance(q, glm::clamp(q, lower, upper)));
      }
    }
  }
  return nearest;
}

TEST_P(EveryFeedRig, NothingStandsInTheWays) {
  const Mesh place = coarsePlaceOf(rig());
  const WalkWays ways = rig().ways();
  for (size_t from = 0; from < ways.places.size(); ++from) {
    for (const size_t to : ways.neighbours[from]) {
      const glm::dvec2& a = ways.places[from];
      const glm::dvec2& b = ways.places[to];
      EXPECT_TRUE(a.x == b.x || a.y == b.y) << "ways of rigs run along the axes, so that this test is exact";
      const glm::dvec2 lower = glm::min(a, b) - ways.halfWidth;
      const glm::dvec2 upper = glm::max(a, b) + ways.halfWidth;
      double nearest = 1e9;
      for (const auto& triangle : place.triangles) {
        std::array<glm::dvec3, 3> corners;
        glm::dvec2 least(1e9);
        glm::dvec2 most(-1e9);
        for (int k = 0; k < 3; ++k) {
          const glm::dvec3 corner(place.positions[triangle[k]]);
          const glm::dvec2 flat(corner.x, corner.z);
          corners[static_cast<size_t>(k)] = corner;
          least = glm::min(least, flat);
          most = glm::max(most, flat);
        }
        if (least.x < upper.x + 1 && least.y < upper.y + 1 && most.x > lower.x - 1 && most.y > lower.y - 1) {
          nearest = std::min(nearest, distanceTo(corners, lower, upper));
        }
      }
      EXPECT_GT(nearest, 0.22) << "half a body beside the way from place " << from << " to " << to;
    }
  }
}

TEST_P(EveryFeedRig, WalkersKeepToTheWays) {
  const WalkWays ways = rig().ways();
  const Walkers walkers(ways, 6, 60, 2);
  for (size_t w = 0; w < walkers.count(); ++w) {
    for (double seconds = 0; seconds < 60; seconds += 0.5) {
      const glm::dvec2 p = walkers.at(w, seconds).place;
      bool isOnWay = false;
      for (size_t from = 0; from < ways.places.size(); ++from) {
        for (const size_t to : ways.neighbours[from]) {
          const glm::dvec2 lower = glm::min(ways.places[from], ways.places[to]) - ways.halfWidth - 1e-6;
          const glm::dvec2 upper = glm::max(ways.places[from], ways.places[to]) + ways.halfWidth + 1e-6;
          isOnWay = isOnWay || (glm::all(glm::lessThanEqual(lower, p)) && glm::all(glm::lessThanEqual(p, upper)));
        }
      }
      EXPECT_TRUE(isOnWay) << w << " at " << seconds;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rigs, EveryFeedRig, testing::Range(size_t{0}, feedRigs().size()),
                         [](const auto& test) { return feedRigs()[test.param].scene; });

TEST(FeedRigs, AnotherSizeSeesNoLess) {
  const FeedSetup small = shopRig().setup();
  for (const auto& [width, height] : {std::pair{640, 480}, {2560, 720}, {1280, 720}}) {
    const FeedSetup other = resizedSetup(small, width, height);
    for (size_t i = 0; i < small.feeds.size(); ++i) {
      for (const glm::dvec2 corner : {glm::dvec2(0, 0), glm::dvec2(1280, 720)}) {
        const auto pixel = feedPixelOf(other.feeds[i], small.feeds[i].pose.eye + *feedRayOf(small.feeds[i], corner));
        ASSERT_TRUE(pixel);
        EXPECT_GE(pixel->x, -1e-6);
        EXPECT_GE(pixel->y, -1e-6);
        EXPECT_LE(pixel->x, width + 1e-6);
        EXPECT_LE(pixel->y, height + 1e-6);
      }
    }
    EXPECT_EQ(other.output.width, width);
    if (width * 9 >= height * 16) {
      EXPECT_NEAR(other.output.fovVerticalDegrees, small.output.fovVerticalDegrees, 1e-9);
    }
  }
  EXPECT_EQ(resizedSetup(small, 1280, 720), small);
}

/// A rolling exposure beside what all rows at once are at the time of each row.
TEST(SimulatedFeed, RowsAreTakenOneAfterTheOther) {
  const FeedRig rig = corridorTRig();
  Feed feed = resizedSetup(rig.setup(), 320, 240).feeds[0];
  const SimulatedFeed camera(feed, coarsePlaceOf(rig));
  const Walkers walkers(rig.ways(), 3, 10, 5);
  constexpr double kRolling = 0.04;
  size_t body = 0;
  size_t differs = 0;
  size_t differsFromGlobal = 0;
  for (const double seconds : {1.0, 2.5, 4.0}) {
    const WalkerMask rolling = camera.mask(walkers, seconds, kRolling);
    const WalkerMask global = camera.mask(walkers, seconds);
    EXPECT_TRUE(camera.frame(walkers, seconds, kRolling).walkers == rolling);
    for (int y = 0; y < feed.height; y += 3) {
      const WalkerMask then = camera.mask(walkers, seconds + kRolling * y / feed.height);
      for (int x = 0; x < feed.width; ++x) {
        body += then(x, y) > 0;
        differs += rolling(x, y) != then(x, y);
        differsFromGlobal += global(x, y) != then(x, y);
      }
    }
  }
  EXPECT_GT(body, 1000u);
  EXPECT_GT(differsFromGlobal, body / 50);
  // Strips of 2.5 ms are off by half of that at most, 1 of 16 of the whole.
  EXPECT_LT(differs, differsFromGlobal / 4);
}

}  // namespace
}  // namespace ocelli
