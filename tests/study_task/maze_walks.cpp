#include "tests/study_task/maze_walks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/base/random.h"
#include "study/task/eye_camera.h"
#include "study/task/floor_plan.h"
#include "tests/worlds/random_mazes.h"

namespace ocelli::test {
namespace {

double share(Random& random) {
  return static_cast<double>(random.next() >> 11) * 0x1p-53;
}

/// Wide passages and narrow ones, thick walls and thin ones.
Maze mazeOf(uint64_t seed) {
  Maze maze = generateMaze(mazeOptions(seed));
  maze.landmarks.clear();
  maze.wallThickness = seed % 3 == 0 ? 0.02f : seed % 3 == 1 ? 0.3f : 1.2f;
  return maze;
}

}  // namespace

void checkRandomWalks(uint64_t mazes, int steps) {
  for (uint64_t seed = 1; seed <= mazes; ++seed) {
    const Maze maze = mazeOf(seed);
    Random random(seed);
    const double clear = static_cast<double>(maze.cellSize) - static_cast<double>(maze.wallThickness);
    const double radius = clear * (0.02 + 0.45 * share(random));
    const FloorPlan plan(maze, radius);
    const glm::vec3 start = maze.centerOf(maze.entrance->cell);
    glm::dvec2 place(start.x, start.z);
    MazeCell cell = maze.entrance->cell;
    double heading = 0;
    for (int i = 0; i < steps; ++i) {
      // Mostly straight on, as someone does who holds a key; sometimes far.
      heading = random.below(20) == 0 ? 2 * kPi * share(random) : heading;
      const double length = random.below(50) == 0 ? radius * 0.9 : 0.0125;
      place = plan.walk(place, length * glm::dvec2(std::sin(heading), -std::cos(heading))).place;
      ASSERT_GE(plan.clearance(place), radius) << "maze " << seed << ", step " << i;
      const glm::vec3 at(glm::dvec3(place.x, 1, place.y));
      ASSERT_FALSE(maze.isInWall(at));
      const std::optional<MazeCell> now = maze.cellAt(at);
      ASSERT_TRUE(now.has_value());
      if (*now != cell) {
        bool isNeighbour = false;
        for (const Direction way : maze.passages(cell)) {
          isNeighbour = isNeighbour || cell.neighbor(way) == *now;
        }
        ASSERT_TRUE(isNeighbour) << "maze " << seed << ", step " << i;
        cell = *now;
      }
    }
  }
}

int64_t refusedPoses(uint64_t mazes, int poses) {
  int64_t refused = 0;
  for (uint64_t seed = 1; seed <= mazes; ++seed) {
    const Maze maze = mazeOf(seed);
    Random random(seed);
    Controls controls;
    controls.bodyRadiusMeters =
        0.45 * share(random) * (static_cast<double>(maze.cellSize) - static_cast<double>(maze.wallThickness)) + 0.02;
    const FloorPlan plan(maze, controls.bodyRadiusMeters);
    const EyeCamera camera(maze, controls, {});
    const double size = static_cast<double>(maze.cellSize);
    for (int i = 0; i < poses;) {
      WalkerPose pose{size * maze.columns() * share(random), size * maze.rows() * share(random),
                      2 * kPi * share(random)};
      if (plan.clearance({pose.x, pose.z}) < controls.bodyRadiusMeters) {
        continue;
      }
      if (random.below(4) == 0) {  // as one often stands: along a corridor
        pose.headingRadians = kPi / 2 * static_cast<double>(random.below(4));
      }
      refused += camera.portalCamera(pose, {320, 180}).has_value() ? 0 : 1;
      ++i;
    }
  }
  return refused;
}

}  // namespace ocelli::test
