#include "analysis/measures/protocol_floor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

using ::testing::HasSubstr;

ProtocolMaze storedMaze() {
  return {"small", {"+-+-+-+", "|     |", "+ +-+ +", "|   | |", "+ +-+-+"}, 2, 0.2};
}

TEST(ProtocolFloor, hasTheLengthsOfTheProtocol) {
  const MazeFloor floor = floorOf(storedMaze());
  EXPECT_EQ(floor.plan().rows(), 2);
  EXPECT_EQ(floor.plan().columns(), 3);
  EXPECT_EQ(floor.shortestMeters({1, 1}, {1, 2}), 10.0);
  EXPECT_TRUE(floor.isClear({1.9, 1}, {1.9, 1.85}));
  EXPECT_FALSE(floor.isClear({1.9, 1}, {1.9, 1.95})) << "the face of the post";
}

TEST(ProtocolFloor, drawingsMustBeMazes) {
  ProtocolMaze maze = storedMaze();
  maze.plan[1] = "|  |";
  EXPECT_THAT(analysisErrorOf([&] { floorOf(maze); }), HasSubstr("maze \"small\" of the protocol"));
  maze.plan.clear();
  EXPECT_THAT(analysisErrorOf([&] { floorOf(maze); }), HasSubstr("not a valid maze"));
  maze = storedMaze();
  maze.plan[1][1] = 'x';
  EXPECT_THAT(analysisErrorOf([&] { floorOf(maze); }), HasSubstr("not a valid maze"));
}

TEST(ProtocolFloor, mazesNeedNotBeWalkable) {
  const MazeFloor floor = floorOf({"shut", {"+ +-+-+", "| |   |", "+ +-+-+"}, 2, 0.2});
  EXPECT_EQ(floor.shortestMeters({0, 0}, {0, 1}), std::nullopt);
  EXPECT_EQ(floor.shortestMeters({0, 1}, {0, 2}), 2.0);
  EXPECT_TRUE(floor.isClear({1, -5}, {1, 5})) << "in through one gap and out through another";
}

}  // namespace
}  // namespace ocelli::test
