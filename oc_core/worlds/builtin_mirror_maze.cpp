// `builtin:mirrormaze`: a maze with a mirroring ball in its middle, which reflects what stands behind corners.
#include <algorithm>
#include <glm/ext/matrix_transform.hpp>

#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/maze_generator.h"
#include "oc_core/worlds/maze_mesh.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

using Kind = BuiltinParameter::Kind;

constexpr uint32_t kMirrorBall = 1;
/// Of a cell.
constexpr double kBallRadius = 0.22;
constexpr size_t kBallLandmarks = 10;

Scene buildMirrorMaze(const BuiltinValues& values) {
  MazeOptions options;
  options.seed = values.count("seed");
  options.rows = static_cast<int>(values.count("rows"));
  options.columns = static_cast<int>(values.count("columns"));
  options.loops = values.number("loops");
  options.landmarks = std::min(kBallLandmarks, values.count("rows") * values.count("columns"));
  const Maze maze = generateMaze(options);
  Scene scene = makeMazeScene(maze);
  // What is reflected is one thing: walls, floor and landmarks.
  for (Instance& instance : scene.instances) {
    instance.object = 0;
  }
  const auto radius = static_cast<float>(kBallRadius * maze.cellSize);
  const glm::vec3 floor = maze.centerOf({options.rows / 2, options.columns / 2});
  scene.add(makeSphere(192),
            glm::scale(glm::translate(glm::mat4(1), floor + glm::vec3(0, radius, 0)), glm::vec3(radius)));
  scene.instances.back().object = kMirrorBall;
  scene.instances.back().tint = palette::ivory();
  return scene;
}

}  // namespace

BuiltinScene mirrorMazeScene() {
  return {.name = "mirrormaze",
          .summary = "a maze with a mirroring ball in its middle (ocelli shade); in metres",
          .parameters = {{"seed", "of the random numbers", Kind::kInteger, "1", 0, 4294967295.0},
                         {"rows", "of cells", Kind::kInteger, "7", 1, 51},
                         {"columns", "of cells", Kind::kInteger, "7", 1, 51},
                         {"loops", "share of the inner walls that is opened again", Kind::kNumber, "0.15", 0, 1}},
          .build = buildMirrorMaze,
          .roles = {{.object = 0, .roles = kCasts | kReceives}, {.object = kMirrorBall, .roles = kMirrors}}};
}

}  // namespace ocelli
