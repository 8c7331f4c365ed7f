#include "oc_core/scene/walk_map.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace ocelli {
namespace {

WalkMap corridorToARoom() {
  WalkMap map;
  WalkCell corridor;
  corridor.kind = WalkCellKind::kTunnel;
  corridor.center = {0, 1, 4};
  corridor.halfLength = 3;
  corridor.rings = {{0, 1, 0.5f, 2}, {6, 0.5f, 0.5f, 3}};
  WalkCell room;
  room.center = {0, 1, -1};
  room.halfLength = 2;
  room.floorRise = 0.5f;
  map.cells = {corridor, room};
  map.portals = {{0, 1, {{0, 2, 1}, {0, 0, 1}, {0.5f, 0, 0}, {0, 1, 0}}}};
  numberCells(map);
  return map;
}

TEST(WalkMap, IsMovedWithItsScene) {
  const WalkMap map = corridorToARoom();
  const glm::mat4 newFromOld = glm::translate(glm::mat4(1), {1, 2, 3}) * glm::scale(glm::mat4(1), glm::vec3(0.5f));
  const WalkMap there = moved(map, newFromOld);
  EXPECT_EQ(there.cells[0].center, glm::vec3(1, 2.5f, 5));
  EXPECT_EQ(there.cells[0].axis, map.cells[0].axis);
  EXPECT_EQ(there.cells[0].halfLength, 1.5f);
  EXPECT_EQ(there.cells[0].rings, (std::vector<WalkRing>{{0, 0.5f, 0.25f, 1}, {3, 0.25f, 0.25f, 1.5f}}));
  EXPECT_EQ(there.cells[1].floorRise, 0.25f);
  EXPECT_EQ(there.portals[0].opening.center, glm::vec3(1, 3, 3.5f));
  EXPECT_EQ(there.portals[0].opening.halfUp, glm::vec3(0, 0.5f, 0));
  EXPECT_EQ(there.partOfCell, map.partOfCell);
  EXPECT_EQ(there.roomOfCell, map.roomOfCell);
}

TEST(WalkMap, PortalsSeenFromTheOtherSideAreTheSameRectangles) {
  WalkPortal portal = corridorToARoom().portals[0];
  portal.isJoint = true;
  const WalkPortal back = portal.reversed();
  EXPECT_EQ(back.from, portal.to);
  EXPECT_EQ(back.to, portal.from);
  EXPECT_TRUE(back.isJoint);
  EXPECT_EQ(glm::cross(back.opening.halfRight, back.opening.halfUp) / 0.5f, back.opening.normal);
  EXPECT_EQ(back.opening.corners()[0], portal.opening.corners()[1]);
  EXPECT_EQ(back.opening.corners()[2], portal.opening.corners()[3]);
}

TEST(WalkMap, PartsAndRoomsAreNumberedByTheirFirstCells) {
  WalkMap map;
  map.cells.resize(5);
  map.portals.resize(3);
  map.portals[0].from = 0;
  map.portals[0].to = 3;
  map.portals[1].from = 4;
  map.portals[1].to = 1;
  map.portals[2].from = 4;
  map.portals[2].to = 3;
  map.portals[2].isJoint = true;
  numberCells(map);
  EXPECT_EQ(map.partOfCell, (std::vector<uint32_t>{0, 0, 1, 0, 0}));
  EXPECT_EQ(map.roomOfCell, (std::vector<uint32_t>{0, 1, 2, 3, 3}));
  EXPECT_EQ(map.partCount(), 2U);
  EXPECT_EQ(map.roomCount(), 4U);
  EXPECT_EQ(map.openingCount(), 2U);
  EXPECT_EQ(WalkMap().roomCount(), 0U);
}

TEST(WalkMap, TheRightOfACellIsOnTheRightOfItsAxis) {
  WalkCell cell;
  cell.axis = {0, 0, -1};  // looking north, east is on the right
  EXPECT_EQ(cell.right(), glm::vec3(1, 0, 0));
}

}  // namespace
}  // namespace ocelli
