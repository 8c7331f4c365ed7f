#include "oc_core/camera/graph_overlap.h"

#include <gmock/gmock.h>

#include <set>

#include "tests/camera/graph_holders.h"
#include "tests/camera/random_graph_cameras.h"

namespace ocelli {
namespace {

using test::holds;
using test::kLower;
using test::kUpper;
using test::Numbers;
using test::randomPoint;
using test::smallCamera;
using test::turnAt;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Two windows whose rays run towards each other from z = 0 on, symmetric to x = 0. The inner edges of the windows are
/// at x = +-gap there, the viewpoints at x = +-6, z = 6, so the inner rays meet at z = -6 gap / (6 - gap).
/// What passes beside the windows ends there.
GraphCamera squinting(double gap) {
  GraphCamera graph(smallCamera());
  const double perUnit = static_cast<double>(graph.root().focalPixels()) / 10;
  const double inner = gap * perUnit;
  graph.bend(0, turnAt({0, 0, 0}, {0, 0, -1}, {-6, 0, 6}), "left",
             {{10, 10}, {45 - inner, 10}, {45 - inner, 50}, {10, 50}});
  graph.bend(0, turnAt({0, 0, 0}, {0, 0, -1}, {6, 0, 6}), "right",
             {{45 + inner, 10}, {80, 10}, {80, 50}, {45 + inner, 50}});
  graph.limit(0, Plane::through({0, 0, 0}, {0, 0, -1}));
  return graph;
}

TEST(GraphOverlap, theCamerasOfTheTestsHaveNone) {
  EXPECT_THAT(overlapsOf(GraphCamera(smallCamera()), kLower, kUpper), IsEmpty());
  EXPECT_THAT(overlapsOf(test::crossroads(), kLower, kUpper), IsEmpty());
  EXPECT_NO_THROW(checkDisjoint(test::crossroads(), kLower, kUpper));
}

// A chain of turns that stays in a world: frusta share planes, and overlap nowhere.
TEST(GraphOverlap, planesThatAreSharedAreNoOverlap) {
  GraphCamera graph(smallCamera());
  int last = 0;
  for (int i = 0; i < 20; ++i) {
    last = graph.bend(last, turnAt({0, 0, 5 - 0.7 * i}, {0.01 * i, 0, -1}, {0.05 * i, 0, 12 - 0.7 * i}), "turn");
  }
  EXPECT_THAT(overlapsOf(graph, kLower, kUpper), IsEmpty());
  EXPECT_THAT(overlapsOf(graph, kLower, kUpper, 1e-9), IsEmpty());
}

TEST(GraphOverlap, beginsWhereRaysMeet) {
  const double gap = 0.5;
  const double meets = -6 * gap / (6 - gap);
  const GraphCamera graph = squinting(gap);
  EXPECT_THAT(overlapsOf(graph, {-4, -4, meets + 0.01}, kUpper), IsEmpty());
  // Just behind where they meet it is a thin wedge.
  const double slope = (6 - gap) / 6;
  const std::vector<FrustumOverlap> overlaps = overlapsOf(graph, {-4, -4, meets - 0.1}, kUpper);
  ASSERT_THAT(overlaps, SizeIs(1));
  EXPECT_EQ(std::pair(overlaps[0].first, overlaps[0].second), std::pair(1, 2));
  const glm::dvec3 point = overlaps[0].point;
  EXPECT_TRUE(holds(graph, 1, point));
  EXPECT_TRUE(holds(graph, 2, point));
  EXPECT_LE(point.z, meets);
  EXPECT_LE(std::abs(point.x), (meets - point.z) * slope);
}

TEST(GraphOverlap, limitsKeepFrustaApart) {
  const double gap = 0.5;
  GraphCamera graph = squinting(gap);
  EXPECT_THAT(overlapsOf(graph, kLower, kUpper), SizeIs(1));
  graph.limit(1, Plane::through({0, 0, 0}, {1, 0, 0}));
  EXPECT_THAT(overlapsOf(graph, kLower, kUpper), SizeIs(1));
  graph.limit(2, Plane::through({0, 0, 0}, {-1, 0, 0}));
  EXPECT_THAT(overlapsOf(graph, kLower, kUpper), IsEmpty());
}

TEST(GraphOverlap, theErrorNamesBothAndAPoint) {
  const GraphCamera graph = squinting(0.5);
  try {
    checkDisjoint(graph, kLower, kUpper);
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("frusta \"left\" and \"right\" both hold the point ("));
    EXPECT_THAT(error.what(), HasSubstr("limit"));
  }
}

// Balls of 0.4 % of the diagonal, which are forty times what counts as an overlap, found by chance.
TEST(GraphOverlap, findsWhatRandomPointsFind) {
  Numbers numbers;
  const double radius = 0.002 * glm::distance(kLower, kUpper);
  size_t byChance = 0;
  size_t reported = 0;
  for (int k = 0; k < 60; ++k) {
    const GraphCamera graph = test::randomGraph(numbers, 5);
    const auto count = static_cast<int>(graph.frusta().size());
    std::set<std::pair<int, int>> found;
    for (const FrustumOverlap& overlap : overlapsOf(graph, kLower, kUpper)) {
      EXPECT_TRUE(holds(graph, overlap.first, overlap.point)) << "camera " << k;
      EXPECT_TRUE(holds(graph, overlap.second, overlap.point)) << "camera " << k;
      EXPECT_LT(overlap.first, overlap.second);
      EXPECT_TRUE(found.insert({overlap.first, overlap.second}).second);
      ++reported;
    }
    std::set<std::pair<int, int>> expected;
    for (int n = 0; n < 10000; ++n) {
      const glm::dvec3 point = randomPoint(numbers);
      const auto holdsBall = [&](int i) {
        bool all = holds(graph, i, point);
        for (int corner = 0; corner < 8 && all; ++corner) {
          all = holds(graph, i,
                      point + radius * glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
        }
        return all;
      };
      std::vector<int> holders;
      for (int i = 0; i < count; ++i) {
        if (holdsBall(i)) {
          holders.push_back(i);
        }
      }
      for (size_t a = 0; a < holders.size(); ++a) {
        for (size_t b = a + 1; b < holders.size(); ++b) {
          expected.insert({holders[a], holders[b]});
        }
      }
    }
    byChance += expected.size();
    for (const auto& pair : expected) {
      EXPECT_TRUE(found.count(pair)) << "camera " << k << ": " << pair.first << ", " << pair.second;
    }
  }
  EXPECT_GT(byChance, 30u);
  EXPECT_LE(byChance, reported);
}

TEST(GraphOverlap, flatWorldsMayBeAskedFor) {
  const GraphCamera graph = squinting(0.5);
  EXPECT_THAT(overlapsOf(graph, {-4, 0, 0.1}, {4, 0, 10}), IsEmpty());
  EXPECT_THAT(overlapsOf(graph, {-4, 0, -14}, {4, 0, 10}), testing::Not(IsEmpty()));
  EXPECT_THAT(overlapsOf(graph, {0, 0, -14}, {0, 0, 10}), testing::Not(IsEmpty()));
}

TEST(GraphOverlap, worldsOutOfSightHaveNone) {
  EXPECT_THAT(overlapsOf(squinting(0.5), {100, 100, 100}, {101, 101, 101}), IsEmpty());
}

TEST(GraphOverlap, refusesWorldsThatAreNone) {
  const GraphCamera graph = test::crossroads();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THROW(overlapsOf(graph, kUpper, kLower), InputError);
  EXPECT_THROW(overlapsOf(graph, kUpper, kUpper), InputError);
  EXPECT_THROW(overlapsOf(graph, {nan, 0, 0}, kUpper), InputError);
  EXPECT_THROW(overlapsOf(graph, kLower, {infinite, 1, 1}), InputError);
  EXPECT_THROW(overlapsOf(graph, kLower, kUpper, 0), InputError);
  EXPECT_THROW(overlapsOf(graph, kLower, kUpper, -1), InputError);
  EXPECT_THROW(overlapsOf(graph, kLower, kUpper, nan), InputError);
  EXPECT_THROW(overlapsOf(graph, kLower, kUpper, infinite), InputError);
  EXPECT_THAT(overlapsOf(test::crossroads(), kLower, kUpper, 1e6), IsEmpty()) << "nothing is that thick";
}

}  // namespace
}  // namespace ocelli
