#include "oc_core/walkable/walk_agreement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/worlds/city_plan.h"
#include "oc_core/worlds/house_plan.h"
#include "oc_core/worlds/plan_walk.h"

namespace ocelli {
namespace {

/// Two rooms of 4 x 6 m side by side, and a door of 1 m between them.
WalkMap twoRooms() {
  WalkMap map;
  map.cells = {levelCell(WalkCellKind::kRoom, {0, 0}, {4, 6}, 0, 2.7f),
               levelCell(WalkCellKind::kRoom, {4, 0}, {8, 6}, 0, 2.7f)};
  map.portals = {{0, 1, uprightOpening({4, 0, 3}, {-1, 0, 0}, 0.5f, 2)}};
  numberCells(map);
  return map;
}

TEST(WalkAgreement, OfAMapWithItselfIsWhole) {
  for (const WalkMap& map : {twoRooms(), cityWalkMap(planCity({1, 100})), houseWalkMap(planHouse({1}))}) {
    const WalkAgreement agreement = compareWalkMaps(map, map);
    EXPECT_EQ(agreement.matchedRooms(), map.roomCount());
    EXPECT_EQ(agreement.matchedPortals(), map.openingCount());
    for (uint32_t room = 0; room < map.roomCount(); ++room) {
      EXPECT_EQ(agreement.foundOfRoom[room], room);
    }
    EXPECT_EQ(agreement.coveredShare, 1);
    EXPECT_EQ(agreement.knownShare, 1);
    EXPECT_EQ(agreement.otherCells, 0u);
  }
}

TEST(WalkAgreement, TellsWhatIsMissedAndWhatIsExtra) {
  const WalkMap known = twoRooms();
  WalkMap found = known;
  // The second room is found as two halves of 3 m, with an opening between them.
  found.cells[1] = levelCell(WalkCellKind::kRoom, {4, 0}, {8, 3.5f}, 0, 2.7f);
  found.cells.push_back(levelCell(WalkCellKind::kRoom, {4, 3.5f}, {8, 6}, 0, 2.7f));
  found.portals.push_back({1, 2, uprightOpening({6, 0, 3.5f}, {0, 0, -1}, 2, 2.7f)});
  numberCells(found);
  const WalkAgreement agreement = compareWalkMaps(known, found);
  EXPECT_EQ(agreement.matchedRooms(), 2u) << "the larger half stands for the room";
  EXPECT_EQ(agreement.foundOfRoom[1], 1u);
  EXPECT_EQ(agreement.reached.size(), 3u);
  EXPECT_EQ(agreement.matchedPortals(), 1u);
  EXPECT_EQ(agreement.reachedPortals.size(), 2u);
  EXPECT_EQ(agreement.coveredShare, 1);
  // Where the larger half is missing, the smaller one is 10 of 24 square metres, and stands for it too.
  found.cells.erase(found.cells.begin() + 1);
  found.portals.clear();
  found.partOfCell = {0, 0};
  found.roomOfCell = {0, 1};
  EXPECT_EQ(compareWalkMaps(known, found).foundOfRoom[1], 1u);
  EXPECT_EQ(compareWalkMaps(known, found, {.roomOverlap = 0.5}).foundOfRoom[1], WalkAgreement::kNone);
  // Places a quarter of a metre apart: rows of them at the border may count for either.
  EXPECT_NEAR(compareWalkMaps(known, found).coveredShare, (24.0 + 10) / 48, 0.25 * 4 / 48);
}

TEST(WalkAgreement, BoxesOfOneRoomCountTogetherAndJointsAreNoOpenings) {
  const WalkMap known = twoRooms();
  WalkMap found = known;
  found.cells[1] = levelCell(WalkCellKind::kRoom, {4, 0}, {8, 3.5f}, 0, 2.7f);
  found.cells.push_back(levelCell(WalkCellKind::kRoom, {4, 3.5f}, {8, 6}, 0, 2.7f));
  found.portals.push_back({1, 2, uprightOpening({6, 0, 3.5f}, {0, 0, -1}, 2, 2.7f), true});
  numberCells(found);
  const WalkAgreement agreement = compareWalkMaps(known, found, {.roomOverlap = 0.999});
  EXPECT_EQ(agreement.matchedRooms(), 2u);
  EXPECT_EQ(agreement.reachedRooms, (std::vector<uint32_t>{0, 1}));
  EXPECT_EQ(agreement.reachedPortals.size(), 2u);
  EXPECT_EQ(agreement.reachedOpenings, 1u);
  // One way round as the other: a joint of the known map is none that is missing.
  const WalkAgreement back = compareWalkMaps(found, known, {.roomOverlap = 0.999});
  EXPECT_EQ(back.matchedRooms(), 2u);
  EXPECT_EQ(back.matchedPortals(), 1u);
}

TEST(WalkAgreement, LeavesOutOtherLevelsAndOtherParts) {
  const WalkMap known = twoRooms();
  WalkMap found = known;
  for (WalkCell roof : known.cells) {
    roof.center.y = 3;
    found.cells.push_back(roof);
    found.partOfCell.push_back(1);
    found.roomOfCell.push_back(static_cast<uint32_t>(found.roomOfCell.size()));
  }
  const WalkAgreement agreement = compareWalkMaps(known, found);
  EXPECT_EQ(agreement.reached.size(), 2u);
  EXPECT_EQ(agreement.otherCells, 2u);
  EXPECT_EQ(agreement.matchedRooms(), 2u);
  for (WalkCell& cell : found.cells) {
    cell.center.y += 3;
  }
  const WalkAgreement above = compareWalkMaps(known, found);
  EXPECT_EQ(above.matchedRooms(), 0u);
  EXPECT_TRUE(above.reached.empty());
}

TEST(WalkAgreement, TakesBoxesThatAreTurned) {
  WalkMap known = twoRooms();
  WalkMap found = known;
  const float turn = 0.5f;  // radians; about the middle of each box
  for (WalkCell& cell : found.cells) {
    cell.axis = {std::sin(turn), 0, -std::cos(turn)};
  }
  const WalkAgreement agreement = compareWalkMaps(known, found);
  EXPECT_EQ(agreement.matchedRooms(), 2u);
  EXPECT_LT(agreement.knownShare, 0.95) << "corners stick out";
  EXPECT_GT(agreement.knownShare, 0.7);
}

TEST(WalkAgreement, OpeningsMatchByPlaceAndDirection) {
  const WalkMap known = twoRooms();
  WalkMap found = known;
  found.portals[0].opening.center.z += 0.9f;
  EXPECT_EQ(compareWalkMaps(known, found).matchedPortals(), 1u);
  found.portals[0].opening.center.z += 0.2f;
  EXPECT_EQ(compareWalkMaps(known, found).matchedPortals(), 0u);
  found = known;
  found.portals[0] = found.portals[0].reversed();
  EXPECT_EQ(compareWalkMaps(known, found).matchedPortals(), 1u);
  found.portals[0].opening = uprightOpening({4, 0, 3}, {0, 0, 1}, 0.5f, 2);
  EXPECT_EQ(compareWalkMaps(known, found).matchedPortals(), 0u);
}

}  // namespace
}  // namespace ocelli
