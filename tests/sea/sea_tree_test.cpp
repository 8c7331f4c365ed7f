// The hierarchy: which images hang on which.
#include "oc_core/sea/sea_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "oc_core/base/random.h"
#include "oc_core/sea/sea_build.h"

namespace ocelli {
namespace {

std::vector<glm::dvec3> scattered(size_t count) {
  Random random(4);
  std::vector<glm::dvec3> positions;
  for (size_t i = 0; i < count; ++i) {
    positions.emplace_back(random.inRange(0, 4), 1.6, random.inRange(0, 3));
  }
  return positions;
}

size_t innerCount(const SeaTree& tree) {
  return static_cast<size_t>(std::count_if(tree.nodes.begin(), tree.nodes.end(),
                                           [](const SeaNode& node) { return node.reference == SeaNode::kNone; }));
}

/// Levels of the tree from `image` up to the I-node that it hangs on.
int levelsAbove(const SeaTree& tree, uint32_t image, const std::set<uint32_t>& inner) {
  int levels = 0;
  while (!inner.contains(image)) {
    image = tree.nodes[image].parent;
    ++levels;
  }
  return levels;
}

std::set<uint32_t> innerOf(const SeaTree& tree) {
  std::set<uint32_t> inner;
  for (uint32_t i = 0; i < tree.nodes.size(); ++i) {
    if (tree.nodes[i].reference == SeaNode::kNone) {
      inner.insert(i);
    }
  }
  return inner;
}

TEST(SeaTree, OfAPairTheSecondHangsOnTheFirst) {
  const SeaTree tree = makeSeaTree(std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}}, SeaWay::kDirect, 4);
  EXPECT_EQ(tree.nodes[0].reference, SeaNode::kNone);
  EXPECT_EQ(tree.nodes[1].reference, 0u);
  EXPECT_THAT(tree.order, testing::ElementsAre(0u, 1u));
}

TEST(SeaTree, TheShortestEdgeCollapsesFirst) {
  // As the text's example of images in a line: the two that are nearest are joined, then those that are next.
  const std::vector<glm::dvec3> line{{0, 0, 0}, {1.9, 0, 0}, {2.4, 0, 0}, {7, 0, 0}, {8, 0, 0}};
  const SeaTree tree = makeSeaTree(line, SeaWay::kRoot, 0);
  EXPECT_EQ(tree.nodes[2].parent, 1u);
  EXPECT_EQ(tree.nodes[4].parent, 3u);
  EXPECT_EQ(tree.nodes[0].parent, 1u);
  EXPECT_EQ(tree.nodes[3].parent, 1u);
  EXPECT_EQ(tree.nodes[1].parent, SeaNode::kNone);
}

TEST(SeaTree, OneINodeStandsForAllFromTheRoot) {
  const SeaTree tree = makeSeaTree(scattered(300), SeaWay::kRoot, 4);
  EXPECT_EQ(innerCount(tree), 1u);
  const uint32_t most = std::max_element(tree.nodes.begin(), tree.nodes.end(), [](const SeaNode& a, const SeaNode& b) {
                          return a.additions < b.additions;
                        })->additions;
  // The text's trees of thousands of images have less than 32 levels.
  EXPECT_GT(most, 2u);
  EXPECT_LE(most, 9u) << "of two trees the lower one goes below the higher one: log2(300)";
}

TEST(SeaTree, NoINodeHasMoreLevelsBelowItThanAsked) {
  for (const int spacing : {1, 2, 4}) {
    const SeaTree tree = makeSeaTree(scattered(300), SeaWay::kIndirect, spacing);
    const std::set<uint32_t> inner = innerOf(tree);
    int most = 0;
    for (uint32_t i = 0; i < tree.nodes.size(); ++i) {
      most = std::max(most, levelsAbove(tree, i, inner));
    }
    EXPECT_EQ(most, spacing);
  }
}

TEST(SeaTree, DirectResidualsAreOneAddition) {
  const SeaTree direct = makeSeaTree(scattered(300), SeaWay::kDirect, 4);
  const SeaTree indirect = makeSeaTree(scattered(300), SeaWay::kIndirect, 4);
  EXPECT_EQ(innerOf(direct), innerOf(indirect));
  uint32_t most = 0;
  for (uint32_t i = 0; i < direct.nodes.size(); ++i) {
    EXPECT_LE(direct.nodes[i].additions, 1u);
    most = std::max(most, indirect.nodes[i].additions);
    if (direct.nodes[i].reference != SeaNode::kNone) {
      // Going from parent to parent one comes to the same I-node.
      uint32_t at = i;
      while (indirect.nodes[at].reference != SeaNode::kNone) {
        at = indirect.nodes[at].reference;
      }
      EXPECT_EQ(at, direct.nodes[i].reference);
    }
  }
  EXPECT_GT(most, 1u);
}

TEST(SeaTree, ASpacingOfNothingMakesEveryImageAnINode) {
  const SeaTree tree = makeSeaTree(scattered(50), SeaWay::kDirect, 0);
  EXPECT_EQ(innerCount(tree), 50u);
}

TEST(SeaTree, OrdersEveryImageBehindItsReference) {
  for (const SeaWay way : allSeaWays()) {
    const SeaTree tree = makeSeaTree(scattered(200), way, 3);
    std::vector<bool> isThere(tree.nodes.size(), false);
    for (const uint32_t image : tree.order) {
      const uint32_t reference = tree.nodes[image].reference;
      EXPECT_TRUE(reference == SeaNode::kNone || isThere[reference]) << nameOf(way);
      isThere[image] = true;
    }
    EXPECT_EQ(std::count(isThere.begin(), isThere.end(), true), 200);
  }
}

TEST(SeaTree, GroupsHangOnEarlierOnesAlone) {
  for (const SeaWay way : allSeaWays()) {
    const SeaTree tree = makeSeaTree(scattered(200), way, 3);
    std::vector<size_t> groupOf(tree.nodes.size(), SIZE_MAX);
    const std::vector<std::vector<uint32_t>> groups = buildGroups(tree);
    for (size_t group = 0; group < groups.size(); ++group) {
      EXPECT_LE(groups[group].size(), 16u);
      for (const uint32_t image : groups[group]) {
        EXPECT_EQ(groupOf[image], SIZE_MAX) << "each stands in one group";
        groupOf[image] = group;
      }
    }
    for (uint32_t i = 0; i < tree.nodes.size(); ++i) {
      ASSERT_NE(groupOf[i], SIZE_MAX);
      if (tree.nodes[i].reference != SeaNode::kNone) {
        EXPECT_LT(groupOf[tree.nodes[i].reference], groupOf[i]);
      }
    }
  }
}

TEST(SeaTree, QualityFollowsEnergyAsTheTextHasIt) {
  const EnergyRange range{10, 2};
  EXPECT_DOUBLE_EQ(adaptedQuality(65, 0.3, 12, range), 65);
  EXPECT_DOUBLE_EQ(adaptedQuality(65, 0.3, 100, range), 65);
  EXPECT_DOUBLE_EQ(adaptedQuality(65, 0.3, 8, range), 65 * 0.7);
  EXPECT_DOUBLE_EQ(adaptedQuality(65, 0.3, 0, range), 65 * 0.7);
  EXPECT_DOUBLE_EQ(adaptedQuality(65, 0.3, 10, range), 65 * 0.85);
  EXPECT_DOUBLE_EQ(adaptedQuality(65, 0.3, 7, {7, 0}), 65) << "where all are alike, none is lowered";
}

}  // namespace
}  // namespace ocelli
