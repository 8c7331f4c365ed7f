#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/scene/ply_file.h"
#include "oc_core/walkable/walkable.h"
#include "tests/base/temporary_folder.h"
#include "tests/walkable/walkable_floors.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

uint32_t partsIn(const WalkMap& map) {
  return *std::max_element(map.partOfCell.begin(), map.partOfCell.end()) + 1;
}

/// A room of 6 x 4 m.
Mesh closedRoom() {
  Mesh mesh;
  test::addFloor(mesh, {-0.2f, -0.2f}, {6.2f, 4.2f});
  test::addWalls(mesh, {0, 0}, {6, 4}, 2.5f);
  return mesh;
}

TEST(Walkable, ARoomIsABox) {
  const WalkMap map = findWalkMap(closedRoom(), {});
  ASSERT_EQ(map.cells.size(), 1U);
  const WalkCell& room = map.cells[0];
  EXPECT_EQ(room.kind, WalkCellKind::kRoom);
  // Within a square of the height field, 0.1 m, on each side.
  EXPECT_NEAR(room.center.x, 3, 0.1f);
  EXPECT_NEAR(room.center.z, 2, 0.1f);
  EXPECT_NEAR(room.center.y, 0, 1e-4f) << "floors are where their triangles are";
  EXPECT_NEAR(room.halfLength, 3, 0.11f);
  EXPECT_NEAR(room.halfWidth, 2, 0.11f);
  EXPECT_NEAR(std::abs(room.axis.x), 1, 1e-5f) << "along the longer side";
  EXPECT_NEAR(room.height, 2.5f, 0.06f);
}

TEST(Walkable, ACeilingBoundsTheHeight) {
  Mesh mesh = closedRoom();
  test::addBox(mesh, {-0.2f, 2.2f, -0.2f}, {6.2f, 2.5f, 4.2f});
  const WalkMap map = findWalkMap(mesh, {});
  ASSERT_EQ(map.cells.size(), 1U);
  EXPECT_NEAR(map.cells[0].height, 2.2f, 0.06f);
}

TEST(Walkable, ADoorPartsTwoRooms) {
  Mesh mesh;
  test::addFloor(mesh, {-0.2f, -0.2f}, {10.2f, 4.2f});
  test::addWalls(mesh, {0, 0}, {10, 4}, 2.5f);
  test::addBox(mesh, {4.9f, 0, 0}, {5.1f, 2.5f, 1.5f});
  test::addBox(mesh, {4.9f, 0, 2.5f}, {5.1f, 2.5f, 4});
  test::addBox(mesh, {4.9f, 2, 1.5f}, {5.1f, 2.5f, 2.5f});  // over the door
  const WalkMap map = findWalkMap(mesh, {});
  ASSERT_EQ(map.cells.size(), 2U);
  ASSERT_EQ(map.portals.size(), 1U);
  const Portal& door = map.portals[0].opening;
  EXPECT_NEAR(door.center.x, 5, 0.2f);
  EXPECT_NEAR(door.center.z, 2, 0.1f);
  EXPECT_NEAR(glm::length(door.halfRight), 0.5f, 0.11f);
  EXPECT_NEAR(glm::length(door.halfUp), 1, 0.06f);
  EXPECT_NEAR(std::abs(door.normal.x), 1, 1e-5f);
}

TEST(Walkable, ATallerAgentDoesNotPassALowDoor) {
  Mesh mesh;
  test::addFloor(mesh, {-0.2f, -0.2f}, {10.2f, 4.2f});
  test::addWalls(mesh, {0, 0}, {10, 4}, 2.5f);
  test::addBox(mesh, {4.9f, 0, 0}, {5.1f, 2.5f, 1.5f});
  test::addBox(mesh, {4.9f, 0, 2.5f}, {5.1f, 2.5f, 4});
  test::addBox(mesh, {4.9f, 2, 1.5f}, {5.1f, 2.5f, 2.5f});
  WalkOptions tall;
  tall.agentHeight = 2.2;
  EXPECT_EQ(partsIn(findWalkMap(mesh, tall)), 2U);
}

TEST(Walkable, IslandsAreParts) {
  Mesh mesh;
  test::addFloor(mesh, {0, 0}, {5, 5});
  test::addFloor(mesh, {8, 0}, {13, 5});
  test::addFloor(mesh, {0, 8}, {1, 9});  // small: left out
  const WalkSurvey survey = surveyWalkable(mesh, {});
  EXPECT_EQ(survey.map.cells.size(), 2U);
  EXPECT_EQ(survey.map.portals.size(), 0U);
  EXPECT_EQ(survey.map.partOfCell, (std::vector<uint32_t>{0, 1}));
  EXPECT_EQ(survey.smallParts, 1U);
  EXPECT_NEAR(survey.smallPartsArea, 1, 0.25);
  WalkOptions all;
  all.partShare = 0;
  EXPECT_EQ(findWalkMap(mesh, all).cells.size(), 3U);
}

TEST(Walkable, StreetsThatCrossAreACrossingAndFourTunnels) {
  Mesh mesh;
  test::addFloor(mesh, {-30, -30}, {30, 30});
  for (const glm::vec2& corner : {glm::vec2(-30, -30), glm::vec2(4, -30), glm::vec2(-30, 4), glm::vec2(4, 4)}) {
    test::addBox(mesh, {corner.x, 0, corner.y}, {corner.x + 26, 9, corner.y + 26});
  }
  WalkOptions options;
  options.partShare = 0.8;  // the roofs are flat
  const WalkMap map = findWalkMap(mesh, options);
  // Each street ends at the border of the ground: the last square of it is a dead end.
  const auto tunnels = std::count_if(map.cells.begin(), map.cells.end(),
                                     [](const WalkCell& c) { return c.kind == WalkCellKind::kTunnel; });
  EXPECT_EQ(tunnels, 4);
  EXPECT_EQ(map.cells.size(), 9U);
  EXPECT_EQ(map.roomCount(), 5U) << "dead ends are parts of their streets";
  EXPECT_EQ(map.openingCount(), 4U);
  const int crossing = test::cellAt(map, {0, 0, 0});
  ASSERT_GE(crossing, 0);
  EXPECT_NEAR(map.cells[crossing].halfLength, 4, 0.15f);
  EXPECT_NEAR(map.cells[crossing].halfWidth, 4, 0.15f);
  for (const glm::vec3& street :
       {glm::vec3(10, 0, 0), glm::vec3(-10, 0, 0), glm::vec3(0, 0, 10), glm::vec3(0, 0, -10)}) {
    const int tunnel = test::cellAt(map, street);
    ASSERT_GE(tunnel, 0);
    EXPECT_EQ(map.cells[tunnel].kind, WalkCellKind::kTunnel);
    EXPECT_NEAR(map.cells[tunnel].height, 9, 0.1f) << "as high as the houses";
    EXPECT_EQ(test::portalsBetween(map, crossing, tunnel), 1U);
  }
}

TEST(Walkable, RingsFollowFacadesThatAreNotAligned) {
  Mesh mesh;
  test::addFloor(mesh, {0, -5}, {40, 15});
  test::addBox(mesh, {0, 0, -5}, {40, 6, 0});
  test::addBox(mesh, {0, 0, 6}, {20, 6, 15});      // the street is 6 m wide here
  test::addBox(mesh, {20, 0, 7.5f}, {40, 9, 15});  // and 7.5 m there
  const WalkMap map = findWalkMap(mesh, {});
  const int tunnel = test::cellAt(map, {20, 0, 3});
  ASSERT_GE(tunnel, 0);
  const WalkCell& street = map.cells[tunnel];
  ASSERT_EQ(street.kind, WalkCellKind::kTunnel);
  ASSERT_GE(street.rings.size(), 4U);
  EXPECT_EQ(street.rings.front().along, 0);
  EXPECT_NEAR(street.rings.back().along, 2 * street.halfLength, 1e-3f);
  const auto widthOf = [](const WalkRing& ring) { return ring.left + ring.right; };
  const bool eastward = street.axis.x > 0;
  const WalkRing& west = eastward ? street.rings.front() : street.rings.back();
  const WalkRing& east = eastward ? street.rings.back() : street.rings.front();
  EXPECT_NEAR(widthOf(west), 6, 0.21f);
  EXPECT_NEAR(widthOf(east), 7.5f, 0.21f);
}

TEST(Walkable, SmallObstaclesAreOverlooked) {
  Mesh mesh = closedRoom();
  test::addBox(mesh, {2.9f, 0, 0.9f}, {3.2f, 2.5f, 1.2f});  // a pillar
  test::addBox(mesh, {1, 0, 2.2f}, {2.4f, 0.8f, 3.2f});     // a table
  test::addBox(mesh, {0, 0, 0}, {2, 0.9f, 0.6f});           // a counter along the wall
  const WalkMap map = findWalkMap(mesh, {});
  ASSERT_EQ(map.cells.size(), 1U);
  EXPECT_NEAR(map.cells[0].halfLength, 3, 0.11f);
  EXPECT_NEAR(map.cells[0].halfWidth, 2, 0.11f);
}

TEST(Walkable, AFencePartsTheFloor) {
  Mesh mesh;
  test::addFloor(mesh, {0, 0}, {10, 5});
  test::addBox(mesh, {4.9f, 0, 0}, {5.1f, 1, 5});
  const WalkMap map = findWalkMap(mesh, {});
  EXPECT_EQ(map.cells.size(), 2U);
  EXPECT_EQ(map.portals.size(), 0U);
}

TEST(Walkable, ScenesOfFilesAreWalkedIn) {
  const test::TemporaryFolder folder;
  writePly(folder / "room.ply", closedRoom());
  GuidedScene scene = loadGuidedScene((folder / "room.ply").string());  // fitted
  const std::vector<std::string> notes = findWays("room.ply", scene);
  ASSERT_TRUE(scene.guides.walk);
  ASSERT_EQ(scene.guides.walk->cells.size(), 1U);
  const float scale = scene.worldFromScene[0][0];
  EXPECT_NEAR(scene.guides.walk->cells[0].halfLength / scale, 3, 0.15f);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], HasSubstr("a metre was taken to be"));
  scene.guides.walk->cells.clear();
  EXPECT_TRUE(findWays("room.ply", scene).empty());
  EXPECT_TRUE(scene.guides.walk->cells.empty()) << "a map that is there stays";
}

TEST(Walkable, FloorsThatFaceDownwardsAreTakenWithANote) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {6, 0, 0}, {6, 0, 4}, {0, 0, 4}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};  // counter-clockwise seen from below
  const WalkSurvey survey = surveyWalkable(mesh, {});
  ASSERT_EQ(survey.notes.size(), 1U);
  EXPECT_THAT(survey.notes[0], HasSubstr("face downwards"));
  EXPECT_EQ(survey.map.cells.size(), 1U);
}

TEST(Walkable, RoofsAreLeftOutUnlessAllPartsAreAskedFor) {
  Mesh mesh = closedRoom();
  test::addBox(mesh, {-0.2f, 2.2f, -0.2f}, {6.2f, 2.5f, 4.2f});
  const WalkSurvey survey = surveyWalkable(mesh, {});
  ASSERT_EQ(survey.map.cells.size(), 1U);
  EXPECT_NEAR(survey.map.cells[0].center.y, 0, 1e-4f) << "though the roof is larger";
  EXPECT_EQ(survey.smallParts, 1U);
  WalkOptions all;
  all.partShare = 0;
  EXPECT_EQ(findWalkMap(mesh, all).cells.size(), 2U);
}

TEST(WalkableErrors, WallsAloneHaveNoFloor) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_THAT(test::walkErrorOf(mesh), HasSubstr("the scene has no floor"));
}

TEST(WalkableErrors, AFloorCanBeTooSmall) {
  Mesh mesh;
  test::addFloor(mesh, {0, 0}, {5, 0.3f});
  EXPECT_THAT(test::walkErrorOf(mesh), HasSubstr("no floor of the scene is wide enough for the agent"));
}

TEST(WalkableErrors, OptionsHaveRanges) {
  WalkOptions options;
  options.cellSize = 0;
  EXPECT_THAT(test::walkErrorOf(closedRoom(), options), HasSubstr("cell_size is 0"));
  options = {};
  options.partShare = 2;
  EXPECT_THAT(test::walkErrorOf(closedRoom(), options), HasSubstr("part_share is 2"));
  options = {};
  options.agentHeight = 1e6;
  EXPECT_THAT(test::walkErrorOf(closedRoom(), options), HasSubstr("how long a metre is"));
  options = {};
  options.cellSize = 1.5;
  EXPECT_THAT(test::walkErrorOf(closedRoom(), options), HasSubstr("give smaller squares"));
}

TEST(Walkable, ASphereHasItsTop) {
  GuidedScene scene = loadGuidedScene("builtin:sphere");
  const WalkMap map = findWalkMap(scene.mesh, inUnits({}, 0.1));
  ASSERT_EQ(map.cells.size(), 1U);
  // As far as its slope is walked on: 40 degrees.
  EXPECT_LT(map.cells[0].halfLength, std::sin(0.7) + 0.02);
  EXPECT_NEAR(map.cells[0].center.y, 1, 0.02f);
}

}  // namespace
}  // namespace ocelli
