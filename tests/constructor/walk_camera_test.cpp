#include "oc_core/constructor/walk_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/random.h"
#include "oc_core/constructor/maze_constructor.h"
#include "oc_core/constructor/walk_from_maze.h"
#include "tests/constructor/image_change.h"
#include "tests/constructor/maze_plans.h"
#include "tests/constructor/maze_seen.h"
#include "tests/constructor/walk_checks.h"
#include "tests/constructor/walk_maps.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

/// As in maze_camera_test.cpp: four cells of street from the entrance to a crossing of four ways.
Maze walkStreet() {
  return test::mazeOfPlan({"+-+-+-+-+-+", "|   |   | |", "+-+ + +-+ +", "|         |", "+-+-+ +-+-+", "|   | |   |",
                           "+ + + + + +", "|   | |   |", "+ +-+ +-+ +", "|   | |   |", "+-+ + + +-+", "|         |",
                           "+-+-+ +-+-+"});
}

WalkPose walkerAt(double east, double south, const glm::dvec3& heading = {0, 0, -1}) {
  return {{east, 1.6, south}, heading};
}

TEST(WalkCamera, seesWhatTheCameraOfTheGridSees) {
  const Maze maze = walkStreet();
  const WalkSpace space(walkMapOf(maze));
  for (const bool backward : {false, true}) {
    WalkCameraOptions options;
    options.backward = backward;
    options.deployWidths = 1;
    MazeCameraOptions gridOptions;
    gridOptions.backward = backward;
    const WalkCamera walk = makeWalkCamera(space, walkerAt(7.6, 11), options, 600, 400);
    const GraphCamera grid = makeMazeCamera(maze, {{7.6, 1.6, 11}, Direction::kNorth}, gridOptions, 600, 400);
    EXPECT_EQ(walk.note, "");
    ASSERT_EQ(walk.ways.size(), backward ? 2u : 3u);
    const GuidedScene scene = test::sceneOf(maze);
    const test::SeenMaze seen = test::seenMaze(walk.camera, maze, scene, maze.landmarks.size());
    const test::SeenMaze gridSeen = test::seenMaze(grid, maze, scene, maze.landmarks.size());
    // Along the ways that leave the crossing. Over the walls both see a little of other cells.
    const std::vector<MazeCell> along = backward ? std::vector<MazeCell>{{5, 0}, {5, 1}, {5, 3}, {5, 4}}
                                                 : std::vector<MazeCell>{{0, 2}, {1, 0}, {1, 1}, {1, 3}, {1, 4}};
    for (const MazeCell& cell : along) {
      EXPECT_GT(seen.cellPixels[maze.indexOf(cell)], 400u) << nameOf(cell);
      EXPECT_GT(gridSeen.cellPixels[maze.indexOf(cell)], 400u) << nameOf(cell);
    }
    test::keepImage(walk.camera, scene.mesh, backward ? "walk_street_backward" : "walk_street");
    test::keepImage(grid, scene.mesh, backward ? "grid_street_backward" : "grid_street");
    EXPECT_EQ(test::overlapCount(walk.camera, scene.mesh), 0u);
    EXPECT_LT(test::differingShare(walk.camera, scene.mesh), 0.005);
  }
}

TEST(WalkCamera, partsRaysByTheSplitRatio) {
  const WalkSpace space(walkMapOf(walkStreet()));
  for (const std::array<double, 3>& split : {std::array{1.0 / 3, 1.0 / 3, 1.0 / 3}, {1.0 / 6, 1.0 / 6, 2.0 / 3}}) {
    WalkCameraOptions options;
    options.split = split;
    options.deployed = 1;
    const WalkCamera walk = makeWalkCamera(space, walkerAt(7.5, 12), options, 600, 400);
    // The opening, in the middle of the passage to the crossing, takes its share of the image's width; so do ways of
    // it.
    double widths = 0;
    for (const WalkWay& way : walk.ways) {
      const auto& frusta = walk.camera.frusta();
      const auto& part = frusta[static_cast<size_t>(frusta[static_cast<size_t>(way.frustum)].parent)].part;
      const auto [least, most] = std::minmax_element(
          part.begin(), part.end(), [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x; });
      EXPECT_NEAR((most->x - least->x) / (options.crossingShare * 600), split[way.side], 1e-3);
      widths += most->x - least->x;
    }
    EXPECT_NEAR(widths, options.crossingShare * 600, 0.5);
  }
}

TEST(WalkCamera, isThePinholeWhereNothingIsDeployed) {
  const test::PlannedHouse house = test::smallHouse();
  const WalkSpace space(house.map());
  WalkCameraOptions options;
  options.deployed = 1e-5;
  const GuidedScene scene = house.scene();
  for (const WalkPose& pose : {walkerAt(2.5, 13), walkerAt(2.9, 10, {0.2, 0, 1}), walkerAt(4, 3, {0, 0, 1})}) {
    const WalkCamera walk = makeWalkCamera(space, pose, options, 120, 80);
    const GraphCamera pinhole(walkPinhole(space, pose, options, 120, 80));
    const auto colors = [&](const GraphCamera& camera) {
      return colorImage(rasterize(camera, scene.mesh), scene.mesh, glm::vec3(0));
    };
    // Where rays turn in planes, and where these meet walls, single pixels along edges may go to the other side.
    EXPECT_LT(test::meanDifference(colors(walk.camera), colors(pinhole)), 2e-3);
  }
}

TEST(WalkCamera, seesIntoAllRoomsOfACorridorAndOfAHall) {
  const test::PlannedHouse house = test::smallHouse();
  for (const float degrees : {0.0f, 27.0f}) {
    const GuidedScene scene = house.scene(degrees);
    const WalkSpace space(*scene.guides.walk);
    const auto turned = [&](const glm::dvec3& v) {
      const double angle = static_cast<double>(degrees) * 3.14159265358979 / 180;
      return glm::dvec3(v.x * std::cos(angle) + v.z * std::sin(angle), v.y,
                        v.z * std::cos(angle) - v.x * std::sin(angle));
    };
    // Along the corridor to the north: the hall ahead, and its doors to both sides.
    const WalkCamera corridor = makeWalkCamera(space, {turned({2.8, 1.6, 13.5}), turned({0, 0, -1})}, {}, 600, 400);
    EXPECT_EQ(corridor.crossing, 0u);
    EXPECT_EQ(corridor.ways.size(), 2u);
    for (const WalkWay& way : corridor.ways) {
      EXPECT_GE(way.frustum, 0) << way.why;
    }
    test::keepImage(corridor.camera, scene.mesh, degrees > 0 ? "walk_corridor_turned" : "walk_corridor");
    EXPECT_TRUE(corridor.camera.projectExactly(turned({10, 2, 1.7})));  // up the stairs
    EXPECT_EQ(test::overlapCount(corridor.camera, scene.mesh), 0u);
    EXPECT_LT(test::differingShare(corridor.camera, scene.mesh), 0.005);
    // In the hall.
    const WalkCamera hall = makeWalkCamera(space, {turned({5, 1.6, 4}), turned({-1, 0, 0})}, {}, 600, 400);
    EXPECT_EQ(hall.crossing, 0u);
    EXPECT_EQ(hall.deployed, 1);
    test::keepImage(hall.camera, scene.mesh, degrees > 0 ? "walk_hall_turned" : "walk_hall");
    EXPECT_GE(hall.camera.frusta().size(), 2u);
    EXPECT_EQ(test::overlapCount(hall.camera, scene.mesh), 0u);
    EXPECT_LT(test::differingShare(hall.camera, scene.mesh), 0.005);
  }
}

/// The largest changes of the images from step to step.
double worstChange(const std::vector<WalkPose>& poses, const GuidedScene& scene, bool pinhole) {
  const WalkSpace space(*scene.guides.walk);
  test::ImageChange change;
  double worst = 0;
  for (const WalkPose& pose : poses) {
    const GraphCamera camera =
        pinhole ? GraphCamera(walkPinhole(space, pose, {}, 120, 80)) : makeWalkCamera(space, pose, {}, 120, 80).camera;
    const double now = change.next(rasterize(camera, scene.mesh), scene.mesh).value_or(0);
    worst = std::max(worst, now);
  }
  return worst;
}

/// Steps of an eighth change an image by an eighth, but for edges, which move by whole pixels of small images. What
/// jumps does so in steps of any size.
constexpr double kShrinks = 0.45;

std::vector<WalkPose> along(const std::vector<glm::dvec3>& points, double step) {
  std::vector<WalkPose> poses;
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const double length = glm::distance(points[i], points[i + 1]);
    for (double at = 0; at < length; at += step) {
      poses.push_back({glm::mix(points[i], points[i + 1], at / length), points[i + 1] - points[i]});
    }
  }
  return poses;
}

TEST(WalkCamera, doesNotJumpWhereOneWalksThroughOpenings) {
  // From a room through the corridor and the hall: an eighth of the step makes so much less of a change.
  const GuidedScene scene = test::smallHouse().scene();
  for (const std::vector<glm::dvec3>& way : {std::vector<glm::dvec3>{{2.8, 1.6, 21}, {2.8, 1.6, 1}},
                                             {{-2, 1.6, 15}, {3, 1.6, 15}},
                                             {{7, 1.6, 12}, {2.4, 1.6, 12}}}) {
    const double whole = worstChange(along(way, 0.16), scene, false);
    const double eighth = worstChange(along(way, 0.02), scene, false);
    EXPECT_LT(eighth, kShrinks * whole);
  }
}

TEST(WalkCamera, doesNotJumpWhereOneTurns) {
  const GuidedScene scene = test::smallHouse().scene();
  for (const glm::dvec3& eye : {glm::dvec3(2.9, 1.6, 13), glm::dvec3(5, 1.6, 4)}) {
    const auto turning = [&](double step) {
      std::vector<WalkPose> poses;
      for (double angle = 0; angle < 6.3; angle += step) {
        poses.push_back({eye, {std::sin(angle), 0, std::cos(angle)}});
      }
      return poses;
    };
    const double whole = worstChange(turning(0.08), scene, false);
    const double eighth = worstChange(turning(0.01), scene, false);
    EXPECT_LT(eighth, kShrinks * whole);
  }
}

TEST(WalkCamera, alwaysGivesAnImage) {
  const WalkSpace space(test::smallHouse().map(27));
  Random random(5);
  size_t noted = 0;
  for (int i = 0; i < 3000; ++i) {
    const glm::dvec3 eye(random.inRange(-15, 20), random.inRange(-1, 6), random.inRange(-20, 25));
    const double angle = random.inRange(0, 6.28f);
    WalkCameraOptions options;
    options.backward = i % 2 == 0;
    if (i % 3 == 0) {
      options.deployed = 1;
    }
    const WalkCamera walk = makeWalkCamera(space, {eye, {std::sin(angle), 0, std::cos(angle)}}, options, 90, 60);
    noted += walk.note.empty() ? 0 : 1;
    EXPECT_EQ(walk.note.empty(),
              walk.camera.frusta().size() > 1 &&
                  std::any_of(walk.ways.begin(), walk.ways.end(), [](const WalkWay& way) { return way.frustum >= 0; }))
        << walk.note;
    for (const WalkWay& way : walk.ways) {
      EXPECT_EQ(way.why.empty(), way.frustum >= 0);
    }
  }
  EXPECT_GT(noted, 500u);
  EXPECT_LT(noted, 2950u);
}

TEST(WalkCamera, saysWhyItIsAPinhole) {
  const WalkSpace space(test::smallHouse().map());
  const auto noteAt = [&](const WalkPose& pose) { return makeWalkCamera(space, pose, {}, 90, 60).note; };
  // From far outside one still sees where the map is.
  EXPECT_GT(makeWalkCamera(space, walkerAt(3000, 2), {}, 90, 60).camera.root().view().zFar, 3000.0f);
  EXPECT_THAT(noteAt(walkerAt(30, 2)), HasSubstr("no walkable floor below"));
  EXPECT_THAT(noteAt(walkerAt(2.8, 6.1)), HasSubstr("retracted"));
  EXPECT_THAT(makeWalkCamera(WalkMap{}, walkerAt(2, 2), {}, 90, 60).note, HasSubstr("no floor to walk on"));
  test::PlannedHouse closed;
  closed.cells = {{{0, 0}, {4, 4}}, {{5, 0}, {6.5f, 8}, true}};
  EXPECT_THAT(makeWalkCamera(closed.map(), walkerAt(2, 2), {}, 90, 60).note, HasSubstr("no way leads out"));
  EXPECT_THAT(makeWalkCamera(closed.map(), walkerAt(6, 2), {}, 90, 60).note, HasSubstr("the way ahead ends"));
}

TEST(WalkCamera, refusesOptionsThatAreNone) {
  const WalkSpace space(test::smallHouse().map());
  const auto errorOf = [&](const WalkPose& pose, const WalkCameraOptions& options = {}) {
    return test::inputErrorOf([&] { makeWalkCamera(space, pose, options, 90, 60); });
  };
  EXPECT_THAT(errorOf({{std::nan(""), 1, 1}, {0, 0, 1}}), HasSubstr("the eye is not finite"));
  EXPECT_THAT(errorOf({{1, 1, 1}, {0, 1, 0}}), HasSubstr("no level part"));
  WalkCameraOptions options;
  options.split = {0.5, 0.6, 0.1};
  EXPECT_THAT(errorOf(walkerAt(2, 2), options), HasSubstr("add up to 1"));
  options = {};
  options.crossingShare = 2;
  EXPECT_THAT(errorOf(walkerAt(2, 2), options), HasSubstr("\"crossing_share\" is 2"));
}

}  // namespace
}  // namespace ocelli
