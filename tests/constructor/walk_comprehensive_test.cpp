#include "oc_core/constructor/walk_comprehensive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/constructor/comprehensive_constructor.h"
#include "oc_core/constructor/walk_from_maze.h"
#include "tests/constructor/maze_plans.h"
#include "tests/constructor/maze_seen.h"
#include "tests/constructor/walk_checks.h"
#include "tests/constructor/walk_maps.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

/// Rays of neighbouring strips cross, and go on through openings beside those that they turn in: 6 % at most of what is
/// seen is shown twice.
constexpr double kMaxTwice = 0.1;

size_t countUnseen(const ComprehensiveWalk& walk) {
  size_t unseen = 0;
  for (size_t i = 0; i < walk.cells.size(); ++i) {
    if (walk.cells[i].unseen != WalkUnseen::kNothing) {
      ++unseen;
      std::printf("cell %zu: %s (%.3f pixels, %zu turns)\n", i, textOf(walk.cells[i].unseen), walk.cells[i].pixels,
                  walk.cells[i].turns);
    }
  }
  return unseen;
}

TEST(ComprehensiveWalk, showsAllCellsOfAHouse) {
  const test::PlannedHouse house = test::smallHouse();
  for (const float degrees : {0.0f, 27.0f}) {
    const GuidedScene scene = house.scene(degrees);
    const ComprehensiveWalk walk = makeComprehensiveWalk(*scene.guides.walk, {}, 960, 600);
    test::keepImage(walk.camera, scene.mesh, degrees > 0 ? "walk_house_turned" : "walk_house");
    EXPECT_EQ(countUnseen(walk), 0u);
    EXPECT_LT(test::shownTwiceShare(walk.camera, scene.mesh), kMaxTwice);
    EXPECT_LT(test::differingShare(walk.camera, scene.mesh), 0.005);
  }
}

TEST(ComprehensiveWalk, showsAllCellsOfGrids) {
  for (const Maze& maze : {test::crossroads(), test::serpentine(5)}) {
    const GuidedScene scene = test::sceneOf(maze);
    const WalkMap map = walkMapOf(maze);
    const ComprehensiveWalk walk = makeComprehensiveWalk(map, {}, 960, 600);
    test::keepImage(walk.camera, scene.mesh, "walk_grid_" + std::to_string(maze.columns()));
    EXPECT_EQ(countUnseen(walk), 0u);
    EXPECT_LT(test::shownTwiceShare(walk.camera, scene.mesh), kMaxTwice);
    EXPECT_LT(test::differingShare(walk.camera, scene.mesh), 0.005);
    const test::SeenMaze seen = test::seenMaze(walk.camera, maze, scene, maze.landmarks.size());
    for (size_t i = 0; i < seen.cellPixels.size(); ++i) {
      EXPECT_GE(seen.cellPixels[i], 4u) << "cell " << i;
    }
  }
}

}  // namespace
}  // namespace ocelli
