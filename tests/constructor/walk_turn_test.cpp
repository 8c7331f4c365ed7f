#include "oc_core/constructor/walk_turn.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "oc_core/constructor/walk_from_maze.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/constructor/image_change.h"
#include "tests/constructor/maze_plans.h"
#include "tests/constructor/walk_checks.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

constexpr size_t kSomeTurns = 12;
/// Of the image: the image before is a little less wide.
constexpr double kSomePixels = 0.03;

TEST(WalkFromMaze, hasRoomsTunnelsAndOpenings) {
  const Maze maze = test::crossroads();
  const WalkMap map = walkMapOf(maze);
  size_t rooms = 0;
  for (const WalkCell& cell : map.cells) {
    rooms += cell.kind == WalkCellKind::kRoom ? 1 : 0;
    EXPECT_EQ(cell.kind == WalkCellKind::kRoom, cell.rings.empty());
  }
  size_t notStraight = 0;
  size_t passages = 0;
  size_t within = 0;  // passages between two straight cells of one corridor
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      const MazeCell cell{row, column};
      notStraight += maze.kind(cell) != CellKind::kStraight ? 1 : 0;
      for (const Direction way : maze.passages(cell)) {
        passages += 1;
        const bool both =
            maze.kind(cell) == CellKind::kStraight && maze.kind(cell.neighbor(way)) == CellKind::kStraight;
        within += both ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(rooms, notStraight);
  EXPECT_EQ(map.portals.size(), (passages - within) / 2);
  // The openings lie where one walks from one to the other.
  for (const WalkPortal& portal : map.portals) {
    EXPECT_GT(glm::dot(map.cells[portal.from].center - portal.opening.center, portal.opening.normal), 0);
    EXPECT_LT(glm::dot(map.cells[portal.to].center - portal.opening.center, portal.opening.normal), 0);
  }
}

/// South of the crossing of four ways, and its openings by the way that they lead.
struct BeforeCrossing {
  BeforeCrossing() : maze(test::crossroads()), space(walkMapOf(maze)), pose{{7.5, 1.6, 12.5}, {0, 0, -1}} {
    const WalkCamera camera = makeWalkCamera(space, pose, {}, 60, 40);
    for (const WalkWay& way : camera.ways) {
      portals[way.side] = way.portal;
      ++count;
    }
  }
  Maze maze;
  WalkSpace space;
  WalkPose pose;
  std::array<uint32_t, 3> portals{};
  size_t count = 0;
};

TEST(WalkTurn, beginsAndEndsAsTheCameraOfTheWalk) {
  const BeforeCrossing before;
  ASSERT_GE(before.count, 2u);
  const GuidedScene scene = test::sceneOf(before.maze);
  const auto colors = [&](const WalkCamera& walk) {
    return colorImage(rasterize(walk.camera, scene.mesh), scene.mesh, glm::vec3(0));
  };
  const uint32_t portal = before.portals[0];
  const auto [ahead, behind] = walkTurningCameras(before.space, {before.pose, portal, 0}, {}, 240, 150);
  EXPECT_EQ(colors(ahead), colors(makeWalkCamera(before.space, before.pose, {}, 240, 150)));
  WalkCameraOptions backward;
  backward.backward = true;
  EXPECT_EQ(colors(behind), colors(makeWalkCamera(before.space, before.pose, backward, 240, 150)));
  const WalkPose after = walkPoseAfter(before.space, {before.pose, portal, 4});
  EXPECT_NEAR(after.heading.x, -1, 1e-6);
  const auto [end, endBehind] = walkTurningCameras(before.space, {before.pose, portal, 4}, {}, 240, 150);
  EXPECT_EQ(colors(end), colors(makeWalkCamera(before.space, after, {}, 240, 150)));
}

TEST(WalkTurn, doesNotJump) {
  // In a grid, whose ways are as wide as its crossings. An eighth of the step makes less of a change.
  const BeforeCrossing before;
  const GuidedScene scene = test::sceneOf(before.maze);
  const auto worst = [&](double step) {
    test::ImageChange forward;
    test::ImageChange backward;
    double most = 0;
    for (double phase = 0; phase <= 4; phase += step) {
      const auto [ahead, behind] =
          walkTurningCameras(before.space, {before.pose, before.portals[0], phase}, {}, 120, 75);
      const double one = forward.next(rasterize(ahead.camera, scene.mesh), scene.mesh).value_or(0);
      const double other = backward.next(rasterize(behind.camera, scene.mesh), scene.mesh).value_or(0);
      most = std::max({most, one, other});
    }
    return most;
  };
  const double whole = worst(0.08);
  const double eighth = worst(0.01);
  std::printf("phase 0.08: %.4f, 0.01: %.4f\n", whole, eighth);
  EXPECT_LT(eighth, 0.6 * whole);
}

/// Of the image ahead, how many pixels show no surface.
size_t emptyPixels(const WalkCamera& walk, const GuidedScene& scene) {
  const FragmentImage fragments = rasterize(walk.camera, scene.mesh);
  return static_cast<size_t>(
      std::count_if(fragments.begin(), fragments.end(), [](const Fragment& each) { return !each.covered(); }));
}

TEST(WalkTurn, theChosenWayShowsWhatIsBehindItsOpenings) {
  // Its sides and its end end rays at first. When its image becomes the pinhole's, none is missing there.
  const GuidedScene scene = loadGuidedScene("builtin:maze,seed=5", {.fit = false});
  const WalkMap map = walkMapOf(*scene.guides.maze);
  const WalkSpace space(map);
  size_t turns = 0;
  for (const WalkCell& cell : map.cells) {
    for (const glm::vec3& heading : {cell.axis, -cell.axis}) {
      const WalkPose pose{glm::dvec3(cell.center) + glm::dvec3(0, 1.6, 0), glm::dvec3(heading)};
      if (cell.kind != WalkCellKind::kTunnel || turns >= kSomeTurns) {
        continue;
      }
      for (const WalkWay& way : makeWalkCamera(space, pose, {}, 64, 40).ways) {
        if (way.frustum < 0 || way.side == 1) {
          continue;
        }
        ++turns;
        const auto empty = [&](double phase) {
          return emptyPixels(walkTurningCameras(space, {pose, way.portal, phase}, {}, 96, 60).first, scene);
        };
        EXPECT_LT(static_cast<double>(empty(3 - 1e-6)), static_cast<double>(empty(3)) + kSomePixels * 96 * 60)
            << "way " << way.portal << " from the cell at " << cell.center.x << ", " << cell.center.z;
      }
    }
  }
  EXPECT_GE(turns, kSomeTurns / 2);
}

TEST(WalkTurn, tellsWhatIsWrong) {
  const BeforeCrossing before;
  const auto errorOf = [&](const WalkTurn& turn) {
    return test::inputErrorOf([&] { walkTurningCameras(before.space, turn, {}, 60, 40); });
  };
  EXPECT_THAT(errorOf({before.pose, before.portals[0], 4.5}), HasSubstr("the phase 4.5"));
  EXPECT_THAT(errorOf({before.pose, 9999, 1}), HasSubstr("is no way out of the crossing ahead"));
  EXPECT_THAT(errorOf({{{-50, 1.6, 0}, {0, 0, -1}}, before.portals[0], 1}), HasSubstr("no crossing lies ahead"));
}

}  // namespace
}  // namespace ocelli
