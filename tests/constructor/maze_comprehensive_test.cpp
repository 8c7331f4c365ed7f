#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/json_fields.h"
#include "oc_core/camera/graph_overlap.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/constructor/comprehensive_constructor.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/base/temporary_folder.h"
#include "tests/constructor/maze_plans.h"
#include "tests/constructor/maze_seen.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

/// How much of the image a frustum takes, of 1.
double areaOf(const GraphCamera& camera, const std::string& name) {
  for (const GraphCamera::Frustum& frustum : camera.frusta()) {
    if (frustum.name == name) {
      double twice = 0;
      for (size_t i = 0; i < frustum.part.size(); ++i) {
        const glm::dvec2 a = frustum.part[i];
        const glm::dvec2 b = frustum.part[(i + 1) % frustum.part.size()];
        twice += a.x * b.y - a.y * b.x;
      }
      return twice / 2 / camera.width() / camera.height();
    }
  }
  ADD_FAILURE() << "there is no frustum " << name;
  return 0;
}

void expectAllSeenOnce(const GraphCamera& camera, const Maze& maze) {
  const GuidedScene scene = test::sceneOf(maze);
  const test::SeenMaze seen = test::seenMaze(camera, maze, scene, maze.landmarks.size());
  for (size_t i = 0; i < seen.cellPixels.size(); ++i) {
    EXPECT_GE(seen.cellPixels[i], 4u) << "cell " << i;
  }
  // Where frusta meet, surfaces overlap by 1/64 pixel: some pixels along the borders, which are more of a small image.
  EXPECT_LT(static_cast<double>(seen.strayPixels), 2e-3 * camera.width() * camera.height() / 7);
}

TEST(ComprehensiveCamera, showsEachCellOfSmallMazesOnce) {
  for (const Maze& maze :
       {test::crossroads(), test::serpentine(5), test::mazeOfPlan({"+-+", "| |", "+ +", "| |", "+ +"})}) {
    for (const TourOrder order : {TourOrder::kBreadthFirst, TourOrder::kDepthFirst}) {
      expectAllSeenOnce(makeComprehensiveCamera(maze, {.order = order, .start = {}, .heading = {}}, 480, 300), maze);
    }
  }
}

TEST(ComprehensiveCamera, showsFloorWhereWaysBegin) {
  // Below the lowest pixel of a wall's top in its column, an image of a maze shows no sky: rays that just miss the
  // beginning of a way meet the floor before it. Embree and the rasteriser both leave out a few that graze an edge.
  const Maze maze = test::crossroads();
  const GuidedScene scene = test::sceneOf(maze);
  const GraphCamera camera = makeComprehensiveCamera(maze, {}, 960, 600);
  const FragmentImage seen = raycast(camera, scene.mesh, RayScene(scene.mesh));
  size_t holes = 0;
  for (int x = 0; x < seen.width(); ++x) {
    bool floorAbove = false;
    for (int y = 0; y < seen.height(); ++y) {
      const bool covered = seen(x, y).covered();
      holes += floorAbove && !covered ? 1 : 0;
      floorAbove = floorAbove || (covered && positionOf(seen(x, y), scene.mesh).y < 1e-3f);
    }
  }
  EXPECT_LE(holes, 10u);
}

TEST(ComprehensiveCamera, fillsTheImageWithTheEntrance) {
  // Less the part below that parallel rays lose: 1 / 50 of the height on one side.
  for (const auto& [width, height] : {std::pair(480, 300), std::pair(300, 300), std::pair(200, 400)}) {
    const GraphCamera camera = makeComprehensiveCamera(test::crossroads(), {}, width, height);
    EXPECT_GT(areaOf(camera, "start"), 0.98) << width << " x " << height;
  }
}

TEST(ComprehensiveCamera, losesNothingAtATurnButWhatTheCorridorTakes) {
  // With a viewpoint far away next to nothing is lost on the way to the last cell.
  ComprehensiveOptions options;
  options.nearness = 0.1;
  options.eyeHeight = 1;
  const Maze maze = test::mazeOfPlan({"+-+-+-+-+-+-+", "|           |", "+ +-+-+-+-+-+"});
  const GraphCamera camera = makeComprehensiveCamera(maze, options, 480, 300);
  // One cell of six: 5 / (5 + 0.1) of the area goes on to the turn, by the distance to its middle.
  EXPECT_NEAR(areaOf(camera, "crossing (row 0, column 0), right"), 5 / 5.1, 0.02);
}

TEST(ComprehensiveCamera, sharesTheImageByTheCellsThatWaysLeadTo) {
  const Maze maze = test::mazeOfPlan({"+-+-+-+-+-+", "|         |", "+-+ +-+-+-+"});
  ComprehensiveOptions even;
  even.evenness = 1;
  ComprehensiveOptions equal;
  equal.evenness = 0;
  for (const auto& [options, ratio] : {std::pair(even, 3.0), std::pair(equal, 1.0)}) {
    const GraphCamera camera = makeComprehensiveCamera(maze, options, 480, 300);
    // Rays part at a point of the far wall, and come in nearly parallel.
    EXPECT_NEAR(
        areaOf(camera, "crossing (row 0, column 1), right") / areaOf(camera, "crossing (row 0, column 1), left"), ratio,
        0.25 * ratio);
  }
}

TEST(ComprehensiveCamera, beginsWhereItIsTold) {
  // In dead ends, with a wall behind.
  const Maze maze = test::crossroads();
  for (const auto& [start, heading] :
       {std::pair(MazeCell{0, 2}, Direction::kSouth), {MazeCell{0, 3}, Direction::kEast}}) {
    ComprehensiveOptions options;
    options.start = start;
    options.heading = heading;
    expectAllSeenOnce(makeComprehensiveCamera(maze, options, 960, 600), maze);
  }
}

TEST(ComprehensiveCamera, beginsInEveryCell) {
  const Maze maze = test::crossroads();
  const Box world = boundsOf(test::sceneOf(maze).mesh);
  size_t cameras = 0;
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      for (const Direction heading : kDirections) {
        if (maze.isOpen({row, column}, heading)) {
          ComprehensiveOptions options;
          options.start = MazeCell{row, column};
          options.heading = heading;
          const GraphCamera camera = makeComprehensiveCamera(maze, options, 960, 600);
          EXPECT_NO_THROW(checkDisjoint(camera, glm::dvec3(world.lower), glm::dvec3(world.upper)))
              << row << ", " << column << " to the " << nameOf(heading);
          ++cameras;
        }
      }
    }
  }
  EXPECT_GT(cameras, maze.cellCount());
}

// In the units of a fitted scene and in metres: walls must not lie where rays end.
TEST(ComprehensiveCamera, showsTheWallsThatItsRaysMeet) {
  for (const bool fit : {true, false}) {
    SceneOptions sceneOptions;
    sceneOptions.fit = fit;
    const GuidedScene scene = loadGuidedScene("builtin:maze,seed=3", sceneOptions);
    const GraphCamera camera = makeComprehensiveCamera(*scene.guides.maze, {}, 480, 300);
    const FragmentImage drawn = rasterize(camera, scene.mesh);
    const FragmentImage cast = raycast(camera, scene.mesh, RayScene(scene.mesh));
    size_t differing = 0;
    for (size_t i = 0; i < drawn.size(); ++i) {
      differing += drawn[i].covered() != cast[i].covered() || std::abs(drawn[i].t - cast[i].t) > 1e-3f * cast[i].t;
    }
    EXPECT_LE(differing, drawn.size() / 200) << (fit ? "fitted" : "in metres");
  }
}

TEST(ComprehensiveCamera, keepsItsWeightsThroughManyTurns) {
  const Maze maze = test::serpentine(26);  // 50 turns
  const GraphCamera camera = makeComprehensiveCamera(maze, {}, 1920, 1200);
  size_t turns = 0;
  for (const GraphCamera::Frustum& frustum : camera.frusta()) {
    turns += frustum.parent >= 0 ? 1 : 0;
    // Of a point beyond the plane, as far as a cell: renderers work with it in single precision.
    const glm::dvec3 point = frustum.plane.crossing(frustum.viewpoint, frustum.viewpoint + frustum.plane.normal) +
                             frustum.plane.normal * 3.0;
    const double weight = (frustum.pixelFromWorld * glm::dvec4(point, 1)).w;
    EXPECT_GT(weight, 1e-10) << frustum.name;
    EXPECT_LT(weight, 1e10) << frustum.name;
  }
  EXPECT_GE(turns, 50u);
  expectAllSeenOnce(camera, maze);
}

TEST(ComprehensiveCamera, tellsWhatIsWrong) {
  const auto errorOf = [](const Maze& maze, const ComprehensiveOptions& options, int width = 480) {
    return test::inputErrorOf([&] { makeComprehensiveCamera(maze, options, width, width); });
  };
  const Maze maze = test::crossroads();
  ComprehensiveOptions options;
  options.start = MazeCell{6, 0};
  EXPECT_THAT(errorOf(maze, options), HasSubstr("without a heading"));
  options.heading = Direction::kNorth;
  EXPECT_THAT(errorOf(maze, options), HasSubstr("(row 6, column 0) is not in the maze"));
  options.start.reset();
  EXPECT_THAT(errorOf(maze, options), HasSubstr("a heading without a start"));
  options.start = MazeCell{0, 1};
  options.heading = Direction::kEast;
  EXPECT_THAT(errorOf(maze, options), HasSubstr("a wall stands to the east of the cell (row 0, column 1)"));
  Maze closed = maze;
  closed.entrance.reset();
  EXPECT_THAT(errorOf(closed, {}), HasSubstr("the maze has no entrance"));
  ComprehensiveOptions near;
  near.nearness = 100;
  EXPECT_THAT(errorOf(test::serpentine(26), near), HasSubstr("does not fit"));
  EXPECT_THAT(errorOf(test::serpentine(40), {}), HasSubstr("turn too often"));
}

TEST(ComprehensiveCamera, isBuiltFromAFile) {
  const test::TemporaryFolder folder;
  const GuidedScene scene = test::sceneOf(test::crossroads());
  const PinholeCamera reference(View{}, 320, 200);
  const std::string file =
      folder.write("camera.json", R"({"camera": "comprehensive", "order": "depth_first", "eye_height": 1.25})");
  const GraphCamera built = std::get<GraphCamera>(constructCamera(file, scene, reference));
  ComprehensiveOptions options;
  options.order = TourOrder::kDepthFirst;
  options.eyeHeight = 1.25;
  const GraphCamera expected = makeComprehensiveCamera(*scene.guides.maze, options, 320, 200);
  ASSERT_EQ(built.frusta().size(), expected.frusta().size());
  EXPECT_EQ(built.frusta().back().part, expected.frusta().back().part);
  // Without the grid, of what the geometry has.
  GuidedScene other = scene;
  other.guides.maze.reset();
  other.mesh.triangles = {glm::uvec3(0, 1, 2)};
  other.mesh.positions = {{0, 0, 0}, {0, 9, 0}, {9, 0, 0}};
  EXPECT_THAT(test::inputErrorOf([&] { constructCamera("comprehensive", other, reference); }),
              testing::AnyOf(HasSubstr("floor"), HasSubstr("Recast")));
}

}  // namespace
}  // namespace ocelli
