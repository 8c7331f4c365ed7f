// What is one room, and what is an opening between two.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/walkable/walkable.h"
#include "tests/walkable/walkable_floors.h"

namespace ocelli {
namespace {

constexpr float kCeiling = 2.5f;

/// A room of that size with a ceiling.
Mesh coveredRoom(const glm::vec2& size) {
  Mesh mesh;
  test::addFloor(mesh, {-0.2f, -0.2f}, {size.x + 0.2f, size.y + 0.2f});
  test::addWalls(mesh, {0, 0}, size, kCeiling);
  test::addBox(mesh, {-0.2f, kCeiling, -0.2f}, {size.x + 0.2f, kCeiling + 0.2f, size.y + 0.2f});
  return mesh;
}

/// The room that holds a point of the floor.
uint32_t roomAt(const WalkMap& map, const glm::vec3& point) {
  const int cell = test::cellAt(map, point);
  EXPECT_GE(cell, 0) << point.x << ", " << point.z;
  return cell < 0 ? 0xffffffffU : map.roomOfCell[static_cast<size_t>(cell)];
}

/// What all maps that are found have in common.
void expectRoomsByJoints(const WalkMap& map) {
  ASSERT_EQ(map.roomOfCell.size(), map.cells.size());
  for (const WalkPortal& portal : map.portals) {
    EXPECT_EQ(portal.isJoint, map.roomOfCell[portal.from] == map.roomOfCell[portal.to]);
  }
}

TEST(WalkableRooms, FurnitureDividesNoRoomAndWallsDo) {
  // From the north wall, 3 of the 4 m to the south wall.
  for (const float top : {2.0f, kCeiling}) {
    Mesh mesh = coveredRoom({8, 4});
    test::addBox(mesh, {3.8f, 0, 0}, {4.4f, top, 3});
    const WalkMap map = findWalkMap(mesh, {});
    expectRoomsByJoints(map);
    const bool isWall = top == kCeiling;
    EXPECT_EQ(map.roomCount(), isWall ? 2U : 1U) << top;
    EXPECT_EQ(map.openingCount(), isWall ? 1U : 0U) << top;
    EXPECT_EQ(roomAt(map, {2, 0, 2}) == roomAt(map, {6, 0, 2}), !isWall) << top;
  }
}

/// A room of 6 x 4 m, and a wing of 2 m to the east of it.
Mesh roomWithWing(float depth) {
  Mesh mesh = coveredRoom({6 + depth, 4});
  test::addBox(mesh, {6, 0, 0}, {6 + depth, kCeiling, 1});
  test::addBox(mesh, {6, 0, 3}, {6 + depth, kCeiling, 4});
  return mesh;
}

TEST(WalkableRooms, ANicheIsPartOfItsRoomAndACorridorIsNone) {
  const WalkMap niche = findWalkMap(roomWithWing(1.5f), {});
  expectRoomsByJoints(niche);
  EXPECT_EQ(niche.roomCount(), 1U);
  EXPECT_EQ(niche.openingCount(), 0U);
  const WalkMap corridor = findWalkMap(roomWithWing(8), {});
  expectRoomsByJoints(corridor);
  EXPECT_EQ(corridor.roomCount(), 2U);
  EXPECT_EQ(corridor.openingCount(), 1U);
  EXPECT_NE(roomAt(corridor, {3, 0, 2}), roomAt(corridor, {10, 0, 2}));
}

TEST(WalkableRooms, ADoorIsAnOpeningWhereverItStands) {
  for (const float from : {0.2f, 1.0f, 1.7f}) {  // along a wall of 3 m: near its end, or in the middle
    Mesh mesh = coveredRoom({8, 3});
    test::addBox(mesh, {3.9f, 0, 0}, {4.1f, kCeiling, from});
    test::addBox(mesh, {3.9f, 0, from + 1}, {4.1f, kCeiling, 3});
    test::addBox(mesh, {3.9f, 2, from}, {4.1f, kCeiling, from + 1});
    const WalkMap map = findWalkMap(mesh, {});
    expectRoomsByJoints(map);
    EXPECT_EQ(map.roomCount(), 2U) << from;
    EXPECT_EQ(map.openingCount(), 1U) << from;
  }
}

TEST(WalkableRooms, BoxesOfOneRoomMeetAtJoints) {
  // Two wings of the same width, at a right angle: no single box fits them.
  Mesh mesh = coveredRoom({10, 10});
  test::addBox(mesh, {4, 0, 4}, {10, kCeiling, 10});
  const WalkMap map = findWalkMap(mesh, {});
  expectRoomsByJoints(map);
  for (const WalkCell& cell : map.cells) {
    EXPECT_LT(4 * cell.halfLength * cell.halfWidth, 60) << "no box covers the solid corner";
  }
}

TEST(WalkableRooms, SmallObstaclesInAnOpeningDoNotPartIt) {
  Mesh mesh = coveredRoom({16, 8});
  test::addBox(mesh, {7.9f, 0, 0}, {8.1f, kCeiling, 2.5f});
  test::addBox(mesh, {7.9f, 0, 5.5f}, {8.1f, kCeiling, 8});
  test::addBox(mesh, {7.8f, 0, 3.9f}, {8.2f, 0.8f, 4.2f});  // a bollard in an opening of 3 m
  const WalkMap map = findWalkMap(mesh, {});
  ASSERT_EQ(map.openingCount(), 1U);
  const auto opening =
      std::find_if(map.portals.begin(), map.portals.end(), [](const WalkPortal& portal) { return !portal.isJoint; });
  EXPECT_NEAR(2 * glm::length(opening->opening.halfRight), 3, 0.25f);
}

}  // namespace
}  // namespace ocelli
