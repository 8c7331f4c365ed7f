// What is found in grid mazes, from their triangles alone, are the cells of their plans: all of them, and nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "oc_core/base/conventions.h"
#include "oc_core/walkable/walk_direction.h"
#include "oc_core/walkable/walk_map_file.h"
#include "oc_core/walkable/walkable.h"
#include "oc_core/worlds/maze_generator.h"
#include "oc_core/worlds/maze_mesh.h"
#include "tests/walkable/walkable_floors.h"

namespace ocelli {
namespace {

/// What the plan of a maze says.
struct PlanCell {
  WalkCellKind kind = WalkCellKind::kRoom;
  glm::vec3 center{0};
  float length = 0;  ///< of a tunnel, between the clear boxes of the cells at its ends; of rooms, their side
};

std::vector<PlanCell> cellsOfPlan(const Maze& maze) {
  const float clear = maze.cellSize - maze.wallThickness;
  std::vector<PlanCell> cells;
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      const MazeCell cell{row, column};
      if (maze.kind(cell) == CellKind::kStraight) {
        continue;
      }
      cells.push_back({WalkCellKind::kRoom, maze.centerOf(cell), clear});
      for (const Direction way : {Direction::kSouth, Direction::kEast}) {
        const std::vector<MazeCell> ahead = maze.ahead(cell, way);
        if (ahead.size() >= 2) {
          const float between = static_cast<float>(ahead.size()) * maze.cellSize - clear;
          cells.push_back({WalkCellKind::kTunnel, (maze.centerOf(cell) + maze.centerOf(ahead.back())) / 2.0f, between});
        }
      }
    }
  }
  return cells;
}

size_t passagesBetweenRooms(const Maze& maze) {
  size_t count = 0;
  for (const PlanCell& cell : cellsOfPlan(maze)) {
    count += cell.kind == WalkCellKind::kTunnel ? 2 : 0;
  }
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      const MazeCell cell{row, column};
      for (const Direction way : {Direction::kSouth, Direction::kEast}) {
        count += maze.kind(cell) != CellKind::kStraight && maze.isOpen(cell, way) &&
                         maze.kind(cell.neighbor(way)) != CellKind::kStraight
                     ? 1
                     : 0;
      }
    }
  }
  return count;
}

/// Without the gap of the entrance, which is floor, too.
Mesh closedMesh(const Maze& maze) {
  return flatten(makeMazeScene(maze, {.closedEntrance = true}));
}

/// The floor in the thickness of a wall, 0.3 m, may belong to the cell on either side.
constexpr float kTolerance = 0.31f;

/// One found cell for each of the plan, and none is left over.
void expectCellsOfPlan(const WalkMap& map, const Maze& maze, double angle, const std::string& what) {
  const std::vector<PlanCell> plan = cellsOfPlan(maze);
  EXPECT_EQ(map.cells.size(), plan.size()) << what;
  std::set<size_t> met;
  Mesh centers;
  for (const PlanCell& cell : plan) {
    centers.positions.push_back(cell.center);
  }
  const std::vector<glm::vec3> turned = turnedAboutVertical(centers, angle).positions;
  for (size_t p = 0; p < plan.size(); ++p) {
    size_t nearest = 0;
    for (size_t i = 0; i < map.cells.size(); ++i) {
      nearest = glm::distance(map.cells[i].center, turned[p]) < glm::distance(map.cells[nearest].center, turned[p])
                    ? i
                    : nearest;
    }
    const WalkCell& found = map.cells[nearest];
    EXPECT_LT(glm::distance(found.center, turned[p]), kTolerance) << what << ", cell " << p;
    EXPECT_EQ(found.kind, plan[p].kind) << what << ", cell " << p;
    EXPECT_NEAR(2 * found.halfLength, plan[p].length, 2 * kTolerance) << what << ", cell " << p;
    EXPECT_NEAR(2 * found.halfWidth, maze.cellSize - maze.wallThickness, kTolerance) << what << ", cell " << p;
    EXPECT_NEAR(found.height, maze.wallHeight, 0.1f) << what << ", cell " << p;
    met.insert(nearest);
  }
  EXPECT_EQ(met.size(), plan.size()) << what << ": two cells of the plan are one";
  EXPECT_EQ(map.portals.size(), passagesBetweenRooms(maze)) << what;
  EXPECT_EQ(*std::max_element(map.partOfCell.begin(), map.partOfCell.end()), 0U) << what;
}

Maze mazeOf(uint64_t seed) {
  MazeOptions options;
  options.seed = seed;
  options.rows = 6 + static_cast<int>(seed % 3);
  options.columns = 7;
  options.landmarks = 0;
  return generateMaze(options);
}

TEST(WalkableMaze, CellsAreThoseOfThePlan) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const Maze maze = mazeOf(seed);
    const WalkMap map = findWalkMap(closedMesh(maze), {});
    expectCellsOfPlan(map, maze, 0, "seed " + std::to_string(seed));
  }
}

TEST(WalkableMaze, TurnedMazesHaveTheSameCells) {
  for (const double degrees : {27.0, 45.0, 80.0}) {
    const Maze maze = mazeOf(2);
    const double angle = radiansFromDegrees(degrees);
    const WalkSurvey survey = surveyWalkable(turnedAboutVertical(closedMesh(maze), angle), {});
    EXPECT_NEAR(survey.directionDegrees, degrees, 1e-3);
    expectCellsOfPlan(survey.map, maze, angle, std::to_string(degrees) + " degrees");
  }
}

TEST(WalkableMaze, OtherUnitsGiveTheSameCells) {
  const Maze maze = mazeOf(3);
  Mesh mesh = closedMesh(maze);
  for (glm::vec3& p : mesh.positions) {
    p *= 100.0f;  // centimetres
  }
  Maze inCentimetres = moved(maze, glm::mat4(glm::mat3(100.0f)));
  const WalkMap map = findWalkMap(mesh, inUnits({}, 100));
  EXPECT_EQ(map.cells.size(), cellsOfPlan(inCentimetres).size());
  EXPECT_EQ(map.portals.size(), passagesBetweenRooms(inCentimetres));
}

TEST(WalkableMaze, PortalsLookIntoTheCellThatTheyAreSeenFrom) {
  const WalkMap map = findWalkMap(closedMesh(mazeOf(1)), {});
  for (const WalkPortal& portal : map.portals) {
    const Portal& opening = portal.opening;
    EXPECT_GT(glm::dot(opening.normal, map.cells[portal.from].center - opening.center), 0);
    EXPECT_LT(glm::dot(opening.normal, map.cells[portal.to].center - opening.center), 0);
    // Products of unit vectors, as floats.
    EXPECT_NEAR(glm::dot(glm::cross(opening.halfRight, opening.halfUp), opening.normal),
                glm::length(opening.halfRight) * glm::length(opening.halfUp), 1e-5);
    EXPECT_NEAR(opening.center.y, glm::length(opening.halfUp), 0.05f) << "it stands on the floor";
  }
}

TEST(WalkableMaze, LandmarksDivideNoCorridor) {
  MazeOptions options;
  options.seed = 4;
  options.landmarks = 10;
  Maze maze = generateMaze(options);
  // Arches leave too little room beside them.
  std::erase_if(maze.landmarks, [](const Landmark& landmark) { return landmark.shape == LandmarkShape::kArch; });
  ASSERT_GT(maze.landmarks.size(), 5U);
  const WalkMap map = findWalkMap(closedMesh(maze), {});
  EXPECT_EQ(map.cells.size(), cellsOfPlan(maze).size());
}

TEST(WalkableMaze, TheSameMeshGivesTheSameBytes) {
  const Mesh mesh = closedMesh(mazeOf(5));
  EXPECT_EQ(jsonText(findWalkMap(mesh, {})), jsonText(findWalkMap(mesh, {})));
}

}  // namespace
}  // namespace ocelli
