// Lanes of the comprehensive camera, and what rays meet on them.
#include "oc_core/constructor/walk_lanes.h"

#include <gtest/gtest.h>

#include "oc_core/constructor/walk_comprehensive.h"
#include "oc_core/constructor/walk_sight.h"
#include "tests/constructor/walk_maps.h"

namespace ocelli {
namespace {

constexpr LaneWay kWay{1, 2, 3};

TEST(WalkLanes, aFreeLaneIsKeptAndNoOtherTried) {
  WalkLanes lanes;
  EXPECT_EQ(lanes.laneOf(kWay), 0u);
  EXPECT_FALSE(lanes.note(kWay, 0, {.free = 1, .floor = 1}));
  EXPECT_EQ(lanes.laneOf(kWay), 0u);
  EXPECT_EQ(lanes.freeOf(kWay), 1);
}

TEST(WalkLanes, allAreTriedAndTheFreestIsTaken) {
  WalkLanes lanes;
  for (size_t lane = 0; lane < walkLanes().size(); ++lane) {
    EXPECT_EQ(lanes.laneOf(kWay), lane);
    EXPECT_EQ(lanes.freeOf(kWay), 1) << "not known yet";
    const bool more = lanes.note(kWay, lane, {.free = lane == 5 ? 0.6 : 0.2, .floor = 1});
    EXPECT_EQ(more, lane + 1 < walkLanes().size());
  }
  EXPECT_EQ(lanes.laneOf(kWay), 5u);
  EXPECT_EQ(lanes.freeOf(kWay), 0.6);
  // It may turn out to be worse where shares of the image have moved.
  lanes.note(kWay, 5, {.free = 0.1, .floor = 1});
  EXPECT_EQ(lanes.laneOf(kWay), 0u);
}

/// Four corners in a circle.
void addWall(Mesh& mesh, const std::vector<glm::vec3>& corners) {
  append(mesh, Mesh{corners, {}, {{0, 1, 2}, {0, 2, 3}}});
}

/// A hall with a room beyond a door, and a wall of 1.6 m across the hall before the door: rays that go straight there
/// end at it.
struct HallWithScreen {
  HallWithScreen() {
    test::PlannedHouse house;
    house.cells = {{{-4, 0}, {4, 8}}, {{-4, -5}, {4, -0.2f}}};
    house.doors = {{0, 1, 0, 1}};
    scene = house.scene();
    empty = scene.mesh;
    addWall(scene.mesh, {{-0.8f, 0, 4}, {0.8f, 0, 4}, {0.8f, 2.4f, 4}, {-0.8f, 2.4f, 4}});
  }

  GuidedScene scene;
  Mesh empty;
};

TEST(WalkSight, raysGoAroundWhatStandsInTheWay) {
  const HallWithScreen hall;
  const WalkMap& map = *hall.scene.guides.walk;
  WalkComprehensiveOptions options;
  options.start = WalkStart{0, {0, 0, -1}};
  const RayScene rays(hall.scene.mesh);
  const WalkSight sight(rays);
  const ComprehensiveWalk blind = makeComprehensiveWalk(map, options, 640, 400);
  std::vector<int> all;
  for (size_t i = 0; i < blind.camera.frusta().size(); ++i) {
    all.push_back(static_cast<int>(i));
  }
  const double before = sight.count(blind.camera, map.cells[1], all).pixels;
  const ComprehensiveWalk seeing = makeComprehensiveWalk(map, options, 640, 400, &rays);
  EXPECT_LT(before, blind.cells[1].pixels / 4) << "the wall hides most of it";
  EXPECT_GT(seeing.cells[1].seenPixels, 2 * before);
  EXPECT_EQ(seeing.cells[1].unseen, WalkUnseen::kNothing);
  // In the empty hall nothing is hidden: counting agrees with the image of the floor.
  const RayScene emptyRays(hall.empty);
  EXPECT_NEAR(WalkSight(emptyRays).count(blind.camera, map.cells[1], all).pixels, blind.cells[1].pixels,
              0.1 * blind.cells[1].pixels + 4);
}

TEST(WalkSight, theReportTellsWhatIsHiddenAndWhere) {
  HallWithScreen hall;
  // The door is closed, though the map has it.
  addWall(hall.scene.mesh, {{-4, 0, 0.05f}, {4, 0, 0.05f}, {4, 2.4f, 0.05f}, {-4, 2.4f, 0.05f}});
  WalkComprehensiveOptions options;
  options.start = WalkStart{0, {0, 0, -1}};
  const RayScene rays(hall.scene.mesh);
  const ComprehensiveWalk walk = makeComprehensiveWalk(*hall.scene.guides.walk, options, 640, 400, &rays);
  EXPECT_EQ(walk.cells[0].unseen, WalkUnseen::kNothing);
  EXPECT_EQ(walk.cells[1].unseen, WalkUnseen::kHidden);
  EXPECT_EQ(walk.cells[1].seenPixels, 0);
  EXPECT_EQ(walk.cells[1].hiddenIn, 0) << "rays end in the hall, at the closed door";
}

}  // namespace
}  // namespace ocelli
