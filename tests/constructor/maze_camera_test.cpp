#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/constructor/maze_constructor.h"
#include "oc_core/constructor/maze_display.h"
#include "oc_core/constructor/maze_turn.h"
#include "oc_core/render/rasterize_graph.h"
#include "tests/base/temporary_folder.h"
#include "tests/constructor/image_change.h"
#include "tests/constructor/maze_plans.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

/// Four cells of street from the entrance to a crossing of four ways.
Maze street() {
  return test::mazeOfPlan({"+-+-+-+-+-+", "|   |   | |", "+-+ + +-+ +", "|         |", "+-+-+ +-+-+", "|   | |   |",
                           "+ + + + + +", "|   | |   |", "+ +-+ +-+ +", "|   | |   |", "+-+ + + +-+", "|         |",
                           "+-+-+ +-+-+"});
}

constexpr double kEast = 7.6;  // a little to the right of the middle of the street
MazePose walker(double south, Direction heading = Direction::kNorth) {
  return {{kEast, 1.6, south}, heading};
}

Image<glm::vec3> imageOf(const GraphCamera& camera, const GuidedScene& scene) {
  return colorImage(rasterize(camera, scene.mesh), scene.mesh, glm::vec3(0.1f));
}

TEST(MazeWalk, findsTheCrossingAhead) {
  const Maze maze = street();
  const auto crossing = crossingAhead(maze, walker(14));
  ASSERT_TRUE(crossing);
  EXPECT_EQ(crossing->cell, (MazeCell{1, 2}));
  // The near face of its clear box is half a wall north of z = 6.
  EXPECT_NEAR(crossing->distance, 14 - (6 - 0.15), 1e-5);
  EXPECT_TRUE(crossing->left && crossing->ahead && crossing->right);
  // Just within its box it is not ahead any more; the next is at a distance of one cell.
  const auto next = crossingAhead(maze, walker(5.8));
  ASSERT_TRUE(next);
  EXPECT_EQ(next->cell, (MazeCell{0, 2}));
  EXPECT_FALSE(next->ahead);
  EXPECT_FALSE(crossingAhead(maze, {{13.5, 1.6, 2}, Direction::kNorth}));
}

TEST(MazeWalk, deploysWithTheDistanceToCrossings) {
  const Maze maze = street();
  EXPECT_DOUBLE_EQ(deployedAt(maze, walker(12), 1), 1);
  EXPECT_NEAR(deployedAt(maze, walker(5.85 + 1.5), 1), 0.5, 1e-5);     // half a cell before the box
  EXPECT_NEAR(deployedAt(maze, walker(15.15 - 0.75), 1), 0.25, 1e-5);  // a quarter behind the crossing at the entrance
  EXPECT_EQ(deployedAt(maze, walker(4.5), 1), 0);                      // in the box
}

TEST(MazeCamera, partsRaysByTheSplitRatio) {
  const Maze maze = street();
  for (const std::array<double, 3>& split : {std::array{1.0 / 3, 1.0 / 3, 1.0 / 3}, {1.0 / 6, 1.0 / 6, 2.0 / 3}}) {
    MazeCameraOptions options;
    options.split = split;
    const GraphCamera camera = makeMazeCamera(maze, walker(11), options, 600, 400);
    const std::vector<SplitLine> lines = splitLines(camera);
    ASSERT_EQ(lines.size(), 2u);
    // The crossing takes the share of the image's width that it is to take, about where the user stands.
    const double middle = 0.5 * 600;
    const auto nearFace = [&](double side) {
      const auto q = camera.projectExactly({7.5 + side * 1.35, 1.6, 5.85 + 1e-6});
      return q ? q->u : middle;
    };
    const double left = nearFace(-1);
    const double right = nearFace(1);
    EXPECT_NEAR(right - left, options.crossingShare * 600, 0.5);
    EXPECT_NEAR((lines[0].u - left) / (right - left), split[0], 1e-3);
    EXPECT_NEAR((right - lines[1].u) / (right - left), split[2], 1e-3);
  }
}

TEST(MazeCamera, seesAlongAllWays) {
  const Maze maze = street();
  const GraphCamera forward = makeMazeCamera(maze, walker(12), {}, 600, 400);
  for (const double east : {1.5, 4.5, 10.5, 13.5}) {  // around the corner, where no pinhole looks
    EXPECT_TRUE(forward.projectExactly({east, 1, 4.5})) << east;
  }
  EXPECT_TRUE(forward.projectExactly({7.5, 1, 1.5}));
  MazeCameraOptions options;
  options.backward = true;
  const GraphCamera backward = makeMazeCamera(maze, walker(12), options, 600, 400);
  EXPECT_TRUE(backward.projectExactly({4.5, 1, 16.5}));
  EXPECT_TRUE(backward.projectExactly({10.5, 1, 16.5}));
  EXPECT_FALSE(backward.projectExactly({7.5, 1, 9}));
}

TEST(MazeCamera, isAPinholeInACrossing) {
  const Maze maze = street();
  const GraphCamera camera = makeMazeCamera(maze, walker(4.5), {}, 600, 400);
  EXPECT_EQ(camera.frusta().size(), 1u);
  EXPECT_EQ(camera.root().view(), mazePinhole(maze, walker(4.5).eye, {0, 0, -1}, {}, 600, 400).view());
}

TEST(MazeCamera, changesAsLittleAsAPinholeWhileOneWalks) {
  // Along the street and through the crossing. Deployed in full, the image is steadier than the pinhole's. While ways
  // deploy it changes more, but without a jump: an eighth of the step makes so much less of a change, as far as pixels
  // tell (edges move by whole ones).
  const Maze maze = street();
  const GuidedScene scene = test::sceneOf(maze);
  const auto changes = [&](double from, double to, double step, const auto& cameraAt) {
    test::ImageChange change;
    std::vector<double> list;
    for (double south = from; south > to; south -= step) {
      if (const auto next = change.next(rasterize(cameraAt(south), scene.mesh), scene.mesh)) {
        list.push_back(*next);
      }
    }
    return *std::max_element(list.begin(), list.end());
  };
  const auto walking = [&](double south) { return makeMazeCamera(maze, walker(south), {}, 240, 150); };
  const auto pinhole = [&](double south) {
    return GraphCamera(mazePinhole(maze, walker(south).eye, {0, 0, -1}, {}, 240, 150));
  };
  EXPECT_LT(changes(12, 9, 0.1, walking), changes(12, 9, 0.1, pinhole));
  const double whole = changes(8.9, 3, 0.1, walking);
  EXPECT_LT(changes(8.9, 3, 0.0125, walking), 0.3 * whole);
}

TEST(MazeTurn, isContinuousAndEndsInTheNewPose) {
  const Maze maze = street();
  const GuidedScene scene = test::sceneOf(maze);
  for (const bool left : {false, true}) {
    test::ImageChange forward;
    test::ImageChange backward;
    double worst = 0;
    std::vector<double> turning;
    for (int i = 0; i <= 80; ++i) {
      const MazeTurn turn{walker(10), left, i / 20.0};
      const auto [ahead, behind] = turningCameras(maze, turn, {}, 240, 150);
      if (const auto change = forward.next(rasterize(ahead, scene.mesh), scene.mesh)) {
        worst = std::max(worst, *change);
      }
      if (const auto change = backward.next(rasterize(behind, scene.mesh), scene.mesh)) {
        turning.push_back(*change);
      }
    }
    // The backward camera is a pinhole that turns by 90 degrees in step 3: nothing changes more than that.
    const double pinhole = *std::max_element(turning.begin() + 40, turning.begin() + 60);
    EXPECT_LT(worst, pinhole);
    EXPECT_LE(*std::max_element(turning.begin(), turning.end()), pinhole);

    const MazePose after = poseAfter(maze, {walker(10), left, 4});
    EXPECT_EQ(after.heading, left ? Direction::kWest : Direction::kEast);
    const GraphCamera last = turningCameras(maze, {walker(10), left, 4}, {}, 240, 150).first;
    EXPECT_EQ(imageOf(last, scene), imageOf(makeMazeCamera(maze, after, {}, 240, 150), scene));
  }
}

TEST(MazeTurn, beginsAsTheCameraOfTheWalk) {
  const Maze maze = street();
  const auto [ahead, behind] = turningCameras(maze, {walker(10), true, 0}, {}, 240, 150);
  const GraphCamera walking = makeMazeCamera(maze, walker(10), {}, 240, 150);
  ASSERT_EQ(ahead.frusta().size(), walking.frusta().size());
  EXPECT_EQ(ahead.frusta().back().part, walking.frusta().back().part);
}

TEST(MazeDisplay, showsWhatIsBehindAtTheLeftAndDrawsSplitLines) {
  const GraphCamera camera = makeMazeCamera(street(), walker(11), {}, 600, 400);
  const GraphCamera plain(PinholeCamera(View{}, 600, 400));
  Image<glm::vec3> behind(600, 400, glm::vec3(0));
  behind(10, 20) = glm::vec3(1);
  const Image<glm::vec3> image = layOut(camera, Image<glm::vec3>(600, 400, glm::vec3(1)), plain, behind);
  EXPECT_EQ(image.width(), 1200);
  EXPECT_EQ(image.height(), 400);
  EXPECT_EQ(image(10, 20), glm::vec3(1));
  const SplitLine line = splitLines(camera)[0];
  EXPECT_LT(image(600 + static_cast<int>(line.u), 200).x, 1);
  EXPECT_EQ(image(600 + static_cast<int>(line.u) + 5, 200).x, 1);
  EXPECT_TRUE(splitLines(plain).empty());
}

TEST(MazeCamera, tellsWhatIsWrong) {
  const Maze maze = street();
  const auto errorOf = [&](const MazePose& pose, const MazeCameraOptions& options = {}) {
    return test::inputErrorOf([&] { makeMazeCamera(maze, pose, options, 60, 40); });
  };
  EXPECT_THAT(errorOf({{6, 1.6, 12}, Direction::kNorth}), HasSubstr("is inside a wall"));
  EXPECT_THAT(errorOf({{-3, 1.6, 12}, Direction::kNorth}), HasSubstr("is outside of the maze"));
  EXPECT_THAT(errorOf({{7.5, std::nan(""), 12}, Direction::kNorth}), HasSubstr("below the floor or above the walls"));
  EXPECT_THAT(errorOf({{std::nan(""), 1, 12}, Direction::kNorth}), HasSubstr("is outside of the maze"));
  EXPECT_THAT(errorOf({{7.5, 3, 12}, Direction::kNorth}), HasSubstr("below the floor or above the walls"));
  EXPECT_THAT(errorOf(walker(12, Direction::kEast)),
              HasSubstr("a wall stands to the east of the cell (row 4, column 2)"));
  MazeCameraOptions options;
  options.split = {0.5, 0.6, -0.1};
  EXPECT_THAT(errorOf(walker(12), options), HasSubstr("\"split\" has a negative share"));
  options.split = {0.5, 0.6, 0.1};
  EXPECT_THAT(errorOf(walker(12), options), HasSubstr("add up to 1.2"));
  options.split = {std::nan(""), 0.5, 0.5};
  EXPECT_NE(errorOf(walker(12), options), "");
  const auto turnError = [&](const MazeTurn& turn) {
    return test::inputErrorOf([&] { turningCameras(maze, turn, {}, 60, 40); });
  };
  EXPECT_THAT(turnError({walker(12), true, 4.5}), HasSubstr("the phase 4.5 is not from 0 to 4"));
  EXPECT_THAT(turnError({walker(2.9), true, 1}), HasSubstr("no way to the left"));
}

TEST(MazeCamera, isBuiltFromAFile) {
  const test::TemporaryFolder folder;
  const GuidedScene scene = test::sceneOf(street());
  const PinholeCamera reference(View{}, 320, 200);
  const std::string file =
      folder.write("camera.json",
                   R"({"camera": "maze", "position": [7.6, 1.6, 11], "heading": "north", "split": [0.25, 0.25, 0.5]})");
  const GraphCamera built = std::get<GraphCamera>(constructCamera(file, scene, reference));
  MazeCameraOptions options;
  options.split = {0.25, 0.25, 0.5};
  const GraphCamera expected = makeMazeCamera(*scene.guides.maze, walker(11), options, 320, 200);
  ASSERT_EQ(built.frusta().size(), expected.frusta().size());
  EXPECT_EQ(built.frusta().back().part, expected.frusta().back().part);
}

}  // namespace
}  // namespace ocelli
