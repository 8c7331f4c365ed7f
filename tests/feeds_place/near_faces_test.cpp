// Near faces in the T of corridors, beside those that were drawn by hand.
#include "oc_core/feeds_place/near_faces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/feeds/feed_graph.h"
#include "oc_core/feeds_measure/feed_rigs.h"
#include "oc_core/walkable/walkable.h"

namespace ocelli {
namespace {

/// Openings are moved to their jambs in steps of 0.01 m, and turned in steps of a degree: 0.045 m at 2.6 m.
constexpr double kFaceError = 0.06;

class NearFacesTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!canFindWalkable()) {
      GTEST_SKIP() << "built without Recast";
    }
    static const FeedPlaceScene kCorridor = loadFeedPlace("builtin:corridor_t", std::nullopt, true);
    place_ = kCorridor;
    setup_ = corridorTRig().setup();
    byHand_ = setup_.frusta;
    setup_.frusta.resize(1);
  }

  FeedPlaceScene place_;
  FeedSetup setup_;
  std::vector<FeedFrustum> byHand_;
};

TEST_F(NearFacesTest, areWhereAPersonWouldDrawThem) {
  const NearFaces found = findNearFaces(setup_, place_);
  EXPECT_TRUE(found.missing.empty());
  ASSERT_EQ(found.faces.size(), 2u);
  ASSERT_EQ(setup_.frusta.size(), 3u);
  const FeedGraph graph(setup_);
  for (size_t i = 1; i < 3; ++i) {
    const auto byHand = std::ranges::find(byHand_, setup_.frusta[i].feed, &FeedFrustum::feed);
    ASSERT_NE(byHand, byHand_.end());
    EXPECT_EQ(setup_.frusta[i].parent, "stem");
    for (const glm::dvec3& corner : byHand->near) {  // from the jamb to the middle of the far wall, floor to ceiling
      double nearest = HUGE_VAL;
      for (const glm::dvec3& each : setup_.frusta[i].near) {
        nearest = std::min(nearest, glm::distance(each, corner));
      }
      EXPECT_LT(nearest, kFaceError) << "frustum " << i;
    }
    EXPECT_GT(found.faces[i - 1].coverage, 0.98);
    EXPECT_NEAR(found.faces[i - 1].turnDegrees, std::atan(1.2 / 2.4) * 180 / 3.14159265, 1);
  }
}

TEST_F(NearFacesTest, areOpeningsWhereNothingIsTurned) {
  const NearFaces found = findNearFaces(setup_, place_, {.maxTurnDegrees = 0});
  ASSERT_EQ(found.faces.size(), 2u);
  for (size_t i = 1; i < 3; ++i) {
    EXPECT_EQ(found.faces[i - 1].turnDegrees, 0);
    for (const glm::dvec3& corner : setup_.frusta[i].near) {
      EXPECT_NEAR(std::abs(corner.x), 1.2, kFaceError);
      EXPECT_TRUE(std::abs(corner.z) < kFaceError || std::abs(corner.z + 2.4) < kFaceError) << corner.z;
      EXPECT_TRUE(std::abs(corner.y) < kFaceError || std::abs(corner.y - 2.8) < kFaceError) << corner.y;
    }
  }
}

TEST_F(NearFacesTest, nameFeedsThatLookThroughNone) {
  // It stands in the branch that it looks along: the root would see it from behind.
  setup_.feeds[1].pose = {{-2, 2.3, -1.2}, {-8, 1.2, -1.2}, {0, 1, 0}};
  Feed wall = setup_.feeds[2];
  wall.name = "wall";
  wall.pose = {{-7.8, 1.6, -1.2}, {-8.2, 1.6, -1.2}, {0, 1, 0}};
  setup_.feeds.push_back(wall);
  const NearFaces found = findNearFaces(setup_, place_);
  ASSERT_EQ(found.faces.size(), 1u);
  EXPECT_EQ(found.faces[0].feed, "right");
  ASSERT_EQ(found.missing.size(), 2u);
  EXPECT_EQ(found.missing[0].feed, "left");
  EXPECT_EQ(found.missing[1].feed, "wall");
  EXPECT_THAT(found.missing[1].why, testing::HasSubstr("sees no opening"));
}

/// Two doors, one behind the other: through the second one sees through the first.
TEST(NearFaces, areSeenThroughOthers) {
  FeedPlaceScene place;
  place.mesh.positions = {{50, 0, 50}, {51, 0, 50}, {50, 1, 50}};  // far from everything
  place.mesh.triangles = {{0, 1, 2}};
  for (const float z : {0.0f, -4.0f}) {
    WalkPortal portal;
    portal.opening = {{0, 1.2f, z}, {0, 0, 1}, {1, 0, 0}, {0, 1.2f, 0}};
    place.map.portals.push_back(portal);
  }
  FeedSetup setup;
  const auto add = [&](const std::string& name, const glm::dvec3& eye) {
    Feed feed;
    feed.name = name;
    feed.source = name + ".mkv";
    feed.lens = {{500, 500}, {320, 240}};
    feed.pose = {eye, eye + glm::dvec3(0, -0.05, -1), {0, 1, 0}};
    setup.feeds.push_back(feed);
  };
  add("last", {0, 2, -1});
  add("first", {0.3, 2, 4.5});
  add("root", {0, 1.6, 5});
  setup.frusta = {{"root", "", {}}};
  setup.output = {320, 240, 50, {0, 1.2, 0}};
  const NearFaces found = findNearFaces(setup, place);
  EXPECT_TRUE(found.missing.empty());
  ASSERT_EQ(setup.frusta.size(), 3u);
  const auto parentOf = [&](const std::string& feed) {
    return std::ranges::find(setup.frusta, feed, &FeedFrustum::feed)->parent;
  };
  EXPECT_EQ(parentOf("first"), "root");
  EXPECT_EQ(parentOf("last"), "first");
  EXPECT_EQ(found.faces[0].turnDegrees, 0) << "it faces the root";
}

TEST_F(NearFacesTest, needOpenings) {
  place_.map.portals.clear();
  EXPECT_THROW(findNearFaces(setup_, place_), InputError);
}

TEST(FeedPlace, isInMetres) {
  const FeedPlaceScene half = loadFeedPlace("builtin:corridor_t", 2.0, false);
  const FeedPlaceScene whole = loadFeedPlace("builtin:corridor_t", std::nullopt, false);
  EXPECT_TRUE(whole.isMetreKnown);
  EXPECT_EQ(whole.metre, 1);
  ASSERT_EQ(half.mesh.positions.size(), whole.mesh.positions.size());
  EXPECT_LT(glm::distance(half.mesh.positions[7] * 2.0f, whole.mesh.positions[7]), 1e-5f);
}

}  // namespace
}  // namespace ocelli
