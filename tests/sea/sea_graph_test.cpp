// The triangulation of positions, against what defines it.
#include "oc_core/sea/sea_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "oc_core/base/disjoint_sets.h"
#include "oc_core/base/random.h"

namespace ocelli {
namespace {

using Edge = std::array<uint32_t, 2>;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

TEST(SeaGraph, TwoPositionsAreNextToEachOther) {
  EXPECT_THAT(delaunayEdges(std::vector<glm::dvec2>{{0, 0}, {3, 1}}), ElementsAre(Edge{0, 1}));
  EXPECT_TRUE(delaunayEdges(std::vector<glm::dvec2>{{5, 5}}).empty());
}

TEST(SeaGraph, PositionsInARowHangTogetherOneByOne) {
  EXPECT_THAT(delaunayEdges(std::vector<glm::dvec2>{{2, 2}, {0, 0}, {1, 1}}), ElementsAre(Edge{0, 2}, Edge{1, 2}));
}

TEST(SeaGraph, PositionsAtOnePlaceHangOnEachOther) {
  EXPECT_THAT(delaunayEdges(std::vector<glm::dvec2>{{0, 0}, {1, 0}, {0, 0}, {0, 0}}),
              UnorderedElementsAre(Edge{0, 1}, Edge{0, 2}, Edge{2, 3}));
}

TEST(SeaGraph, ASquareHasOneDiagonalAtMost) {
  const std::vector<Edge> edges = delaunayEdges(std::vector<glm::dvec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const std::set<Edge> found(edges.begin(), edges.end());
  for (const Edge& side : {Edge{0, 1}, Edge{1, 2}, Edge{2, 3}, Edge{0, 3}}) {
    EXPECT_TRUE(found.contains(side));
  }
  EXPECT_FALSE(found.contains({0, 2}) && found.contains({1, 3}));
}

/// Two positions are next to each other exactly where some circle through both has no other one inside: it is enough to
/// look at the circles through each third one.
bool isDelaunay(const std::vector<glm::dvec2>& positions, uint32_t a, uint32_t b) {
  // Centres of circles through both lie at middle + s * across: each other position allows s on one side of a bound.
  const glm::dvec2 middle = (positions[a] + positions[b]) * 0.5;
  const glm::dvec2 along = positions[b] - positions[a];
  const glm::dvec2 across{-along.y, along.x};
  double least = -1e300;
  double most = 1e300;
  for (uint32_t i = 0; i < positions.size(); ++i) {
    if (i == a || i == b) {
      continue;
    }
    const glm::dvec2 way = positions[i] - middle;
    const double side = 2 * glm::dot(way, across);
    const double bound = (glm::dot(way, way) - glm::dot(along, along) / 4) / side;
    (side > 0 ? most : least) = side > 0 ? std::min(most, bound) : std::max(least, bound);
  }
  return least < most;
}

TEST(SeaGraph, AnEdgeStandsExactlyWhereACircleIsEmpty) {
  Random random(1);
  for (int round = 0; round < 5; ++round) {
    std::vector<glm::dvec2> positions;
    for (int i = 0; i < 40; ++i) {
      positions.emplace_back(random.inRange(-3, 5), random.inRange(0, 1));
    }
    const std::vector<Edge> edges = delaunayEdges(positions);
    const std::set<Edge> found(edges.begin(), edges.end());
    for (uint32_t a = 0; a < positions.size(); ++a) {
      for (uint32_t b = a + 1; b < positions.size(); ++b) {
        EXPECT_EQ(found.contains({a, b}), isDelaunay(positions, a, b)) << a << " " << b;
      }
    }
  }
}

TEST(SeaGraph, TakesTheTwoAxesThatSpreadWidest) {
  const std::vector<glm::dvec3> level{{0, 1.6, 0}, {3, 1.61, -4}};
  EXPECT_THAT(planePositions(level), ElementsAre(glm::dvec2(0, 0), glm::dvec2(3, -4)));
  const std::vector<glm::dvec3> upright{{0, 1, 0}, {3, 9, 0.5}};
  EXPECT_THAT(planePositions(upright), ElementsAre(glm::dvec2(0, 1), glm::dvec2(3, 9)));
}

}  // namespace
}  // namespace ocelli
