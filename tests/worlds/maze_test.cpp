#include "oc_core/scene/maze.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/base/error.h"
#include "oc_core/worlds/maze_file.h"
#include "oc_core/worlds/maze_graph.h"
#include "oc_core/worlds/maze_validate.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

// A ring of corridors around two walls, a four-way crossing in its middle, a dead end in the north-east.
//    0 1 2 3
constexpr const char* kText = R"({"plan": [
  "+-+-+-+-+",
  "|     |  ",
  "+ + + + +",
  "|       |",
  "+ + + +-+",
  "|       |",
  "+-+-+-+-+"], "cell_size": 2, "wall_height": 3, "wall_thickness": 0.5})";

Maze example() {
  return mazeFromJsonText(kText, "example");
}

TEST(Maze, DirectionsTurnLikeACompass) {
  for (const Direction direction : kDirections) {
    EXPECT_EQ(leftOf(rightOf(direction)), direction);
    EXPECT_EQ(rightOf(rightOf(direction)), opposite(direction));
    // Right of a direction in a frame with y up.
    EXPECT_EQ(vectorOf(rightOf(direction)), glm::cross(vectorOf(direction), glm::vec3(0, 1, 0)));
    EXPECT_EQ(vectorOf(opposite(direction)), -vectorOf(direction));
  }
  EXPECT_EQ(rightOf(Direction::kNorth), Direction::kEast);
  EXPECT_EQ((MazeCell{2, 3}.neighbor(Direction::kNorth)), (MazeCell{1, 3}));
  EXPECT_EQ((MazeCell{2, 3}.neighbor(Direction::kEast)), (MazeCell{2, 4}));
}

TEST(Maze, KnowsItsPassages) {
  const Maze maze = example();
  EXPECT_EQ(maze.entrance->cell, (MazeCell{0, 3}));
  EXPECT_EQ(maze.entrance->heading, Direction::kWest);
  EXPECT_EQ(maze.kind({0, 3}), CellKind::kDeadEnd);
  EXPECT_EQ(maze.kind({0, 0}), CellKind::kTurn);
  EXPECT_EQ(maze.kind({0, 1}), CellKind::kThreeWay);
  EXPECT_EQ(maze.kind({1, 1}), CellKind::kFourWay);
  EXPECT_EQ(maze.kind({1, 3}), CellKind::kTurn);
  EXPECT_EQ(maze.kind({2, 3}), CellKind::kDeadEnd);
  EXPECT_THAT(maze.passages({0, 1}), ElementsAre(Direction::kEast, Direction::kSouth, Direction::kWest));
  EXPECT_FALSE(maze.isOpen({0, 3}, Direction::kEast)) << "the entrance leads to no cell";
  EXPECT_EQ(Maze(2, 2).kind({0, 0}), CellKind::kClosed);
}

TEST(Maze, LooksAheadToTheFirstChoice) {
  const Maze maze = mazeFromJsonText(R"({"plan": [
    "+-+-+-+-+-+",
    "          |",
    "+-+-+-+ +-+",
    "|       | |",
    "+-+-+-+ + +",
    "|         |",
    "+-+-+-+-+-+"]})",
                                     "example");
  EXPECT_THAT(maze.ahead({0, 0}, Direction::kEast), ElementsAre(MazeCell{0, 1}, MazeCell{0, 2}, MazeCell{0, 3}));
  EXPECT_THAT(maze.ahead({0, 3}, Direction::kEast), ElementsAre(MazeCell{0, 4}));
  EXPECT_THAT(maze.ahead({0, 4}, Direction::kWest), ElementsAre(MazeCell{0, 3}));
  EXPECT_THAT(maze.ahead({0, 0}, Direction::kSouth), ElementsAre());
}

TEST(Maze, FindsTheCellOfAPoint) {
  const Maze maze = example();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      const MazeCell cell{row, column};
      EXPECT_EQ(maze.cellAt(maze.centerOf(cell)), cell);
      EXPECT_FALSE(maze.isInWall(maze.centerOf(cell)));
    }
  }
  EXPECT_EQ(maze.centerOf({1, 2}), glm::vec3(5, 0, 3));
  EXPECT_EQ(maze.cellAt({7.99f, 100, 0}), (MazeCell{0, 3}));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const glm::vec3& outside : {glm::vec3(8, 0, 1), glm::vec3(-0.01f, 0, 1), glm::vec3(1, 0, 6),
                                   glm::vec3(nan, 0, 1), glm::vec3(1, 0, infinity), glm::vec3(-1e30f, 0, 1)}) {
    EXPECT_EQ(maze.cellAt(outside), std::nullopt);
  }
}

TEST(Maze, TellsWallsFromPassages) {
  const Maze maze = example();
  EXPECT_TRUE(maze.isInWall({2, 1, 2})) << "a post between four passages";
  EXPECT_TRUE(maze.isInWall({2.25f, 1, 2.25f}));
  EXPECT_FALSE(maze.isInWall({2.26f, 1, 2.25f}));
  EXPECT_FALSE(maze.isInWall({2, 1, 1})) << "a passage";
  EXPECT_TRUE(maze.isInWall({6, 1, 1})) << "a wall";
  EXPECT_TRUE(maze.isInWall({5.75f, -50, 1}));
  EXPECT_FALSE(maze.isInWall({5.74f, 1, 1}));
  EXPECT_TRUE(maze.isInWall({-0.25f, 1, 1})) << "the outer wall, its outer half";
  EXPECT_FALSE(maze.isInWall({-0.26f, 1, 1}));
  EXPECT_TRUE(maze.isInWall({8.2f, 1, 3}));
  EXPECT_FALSE(maze.isInWall({8, 1, 1})) << "the entrance";
  EXPECT_FALSE(maze.isInWall({8.2f, 1, 1}));
  EXPECT_TRUE(maze.isInWall({8.2f, 1, -0.2f})) << "the outer corner";
  EXPECT_TRUE(maze.isInWall({5, 1, 6.2f}));
  EXPECT_FALSE(maze.isInWall({std::numeric_limits<float>::quiet_NaN(), 1, 1}));
  EXPECT_FALSE(maze.isInWall({1e30f, 1, 1}));
}

TEST(Maze, GivesBoxesAndOpenings) {
  const Maze maze = example();
  const Box whole = maze.cellBox({1, 2});
  EXPECT_EQ(whole.lower, glm::vec3(4, 0, 2));
  EXPECT_EQ(whole.upper, glm::vec3(6, 3, 4));
  const Box clear = maze.clearBox({1, 2});
  EXPECT_EQ(clear.lower, glm::vec3(4.25f, 0, 2.25f));
  EXPECT_EQ(clear.upper, glm::vec3(5.75f, 3, 3.75f));
  for (const Direction direction : kDirections) {
    const Portal opening = maze.openingOf({1, 2}, direction);
    EXPECT_EQ(opening.normal, -vectorOf(direction));
    EXPECT_EQ(opening.center, glm::vec3(5, 1.5f, 3) + 0.75f * vectorOf(direction));
    EXPECT_EQ(glm::length(opening.halfRight), 0.75f);
    EXPECT_EQ(opening.halfUp, glm::vec3(0, 1.5f, 0));
    // Right-handed, so that corners() are counter-clockwise seen from the cell.
    EXPECT_EQ(glm::normalize(glm::cross(opening.halfRight, opening.halfUp)), opening.normal);
  }
  EXPECT_EQ(maze.openingOf({0, 3}, Direction::kEast).center, glm::vec3(7.75f, 1.5f, 1)) << "the entrance";
}

TEST(Maze, MovesWithItsScene) {
  const Maze maze = example();
  glm::mat4 worldFromScene = glm::translate(glm::mat4(1), {1, 2, 3});
  worldFromScene = glm::scale(worldFromScene, glm::vec3(0.5f));
  const Maze small = moved(maze, worldFromScene);
  EXPECT_EQ(small.centerOf({1, 2}), glm::vec3(worldFromScene * glm::vec4(maze.centerOf({1, 2}), 1)));
  EXPECT_EQ(small.clearBox({1, 2}).upper, glm::vec3(worldFromScene * glm::vec4(maze.clearBox({1, 2}).upper, 1)));
  EXPECT_EQ(small.cellAt(small.centerOf({2, 3})), (MazeCell{2, 3}));
  EXPECT_TRUE(small.isInWall(glm::vec3(worldFromScene * glm::vec4(5.8f, 1, 1, 1))));
  EXPECT_FALSE(small.isInWall(glm::vec3(worldFromScene * glm::vec4(5.7f, 1, 1, 1))));
  const Portal opening = small.openingOf({1, 1}, Direction::kNorth);
  const Portal expected = moved(maze.openingOf({1, 1}, Direction::kNorth), worldFromScene);
  EXPECT_EQ(opening.corners(), expected.corners());
}

TEST(MazeGraph, FindsCorridorsCrossingsAndLoops) {
  const MazeGraph graph(example());
  // From the drawing: row 0 has 0-2; rows 1 and 2 are whole; columns 0, 1 and 2 are whole; column 3 has rows 0 and 1.
  ASSERT_EQ(graph.corridors.size(), 7u);
  EXPECT_EQ(graph.count(CellKind::kFourWay), 2u);   // (1, 1), (1, 2)
  EXPECT_EQ(graph.count(CellKind::kThreeWay), 4u);  // (0, 1), (1, 0), (2, 1), (2, 2)
  EXPECT_EQ(graph.count(CellKind::kTurn), 4u);      // (0, 0), (0, 2), (1, 3), (2, 0)
  EXPECT_THAT(graph.deadEnds, ElementsAre(MazeCell{0, 3}, MazeCell{2, 3}));
  EXPECT_EQ(graph.loops, 4u);  // 2 + 3 + 3 passages to the east and 4 + 3 to the south, for 12 cells
  const std::optional<size_t> row = graph.corridorOf({0, 1}, true);
  ASSERT_TRUE(row);
  EXPECT_THAT(graph.corridors[*row].cells, ElementsAre(MazeCell{0, 0}, MazeCell{0, 1}, MazeCell{0, 2}));
  EXPECT_TRUE(graph.corridors[*row].eastWest);
  EXPECT_EQ(graph.corridorOf({0, 3}, true), std::nullopt);
  for (const Crossing& crossing : graph.crossings) {
    EXPECT_THAT(graph.corridors.at(crossing.eastWest).cells, testing::Contains(crossing.cell));
    EXPECT_THAT(graph.corridors.at(crossing.northSouth).cells, testing::Contains(crossing.cell));
    EXPECT_TRUE(graph.corridors[crossing.eastWest].eastWest);
    EXPECT_FALSE(graph.corridors[crossing.northSouth].eastWest);
  }
}

TEST(MazeValidation, NamesTheCell) {
  const auto expectComplaint = [](const Maze& maze, const auto& matcher) {
    EXPECT_THAT([&] { validate(maze, "here"); }, ThrowsMessage<InputError>(AllOf(HasSubstr("here"), matcher)));
  };
  const Maze good = example();
  EXPECT_NO_THROW(validate(good, "here"));
  Maze maze = good;
  maze.entrance.reset();
  expectComplaint(maze, HasSubstr("no entrance"));
  maze = good;
  maze.entrance->cell = {3, 0};
  expectComplaint(maze, AllOf(HasSubstr("(row 3, column 0)"), HasSubstr("3 rows and 4 columns")));
  maze.entrance = {{1, 1}, Direction::kNorth};
  expectComplaint(maze, AllOf(HasSubstr("(row 1, column 1)"), HasSubstr("south")));
  maze = good;
  maze.setOpen({2, 2}, Direction::kEast, false);
  expectComplaint(maze, AllOf(HasSubstr("(row 2, column 3)"), HasSubstr("cannot be reached")));
  for (float Maze::*const size : {&Maze::cellSize, &Maze::wallHeight, &Maze::wallThickness}) {
    for (const float bad : {0.0f, -1.0f, std::numeric_limits<float>::infinity(), std::nanf("")}) {
      maze = good;
      maze.*size = bad;
      expectComplaint(maze, HasSubstr("positive"));
    }
  }
  maze = good;
  maze.wallThickness = 1.01f;
  expectComplaint(maze, HasSubstr("no passage"));
  maze = Maze(1, 1);
  expectComplaint(maze, HasSubstr("one cell"));
  const auto withLandmark = [&](const Landmark& landmark) {
    maze = good;
    maze.landmarks = {{{0, 0}}, landmark};
    return maze;
  };
  expectComplaint(withLandmark({{3, 1}}), AllOf(HasSubstr("landmark 2"), HasSubstr("(row 3, column 1)")));
  expectComplaint(withLandmark({{0, -1}}), HasSubstr("(row 0, column -1)"));
  // Half of a cell, 0.125 of a half wall, 0.13 of the landmark: 0.245 remain.
  EXPECT_NO_THROW(validate(withLandmark({{1, 1}, LandmarkShape::kCone, {}, 0.24f, -0.24f}), "here"));
  expectComplaint(withLandmark({{1, 1}, LandmarkShape::kCone, {}, 0.25f, 0}),
                  AllOf(HasSubstr("(row 1, column 1)"), HasSubstr("cone"), HasSubstr("wall")));
  expectComplaint(withLandmark({{1, 1}, LandmarkShape::kCone, {}, 0, std::nanf("")}), HasSubstr("landmark 2"));
  expectComplaint(withLandmark({{1, 1}, LandmarkShape::kArch}), HasSubstr("no passage to span"));
  EXPECT_NO_THROW(validate(withLandmark({{2, 3}, LandmarkShape::kArch}), "here"));
  expectComplaint(withLandmark({{2, 3}, LandmarkShape::kArch, {}, 0.1f, 0}), HasSubstr("is moved"));
}

}  // namespace
}  // namespace ocelli
