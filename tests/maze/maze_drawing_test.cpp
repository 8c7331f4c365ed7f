#include "oc_core/maze/maze_drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

using Lines = std::vector<std::string>;

const Lines kSmall{
    "+-+-+-+", "|     |", "+ +-+ +", "|   | |", "+ +-+-+",
};

TEST(MazeDrawing, readsPassagesAndGaps) {
  const MazeDrawing drawing = readDrawing(kSmall, "here");
  EXPECT_EQ(drawing.plan.rows(), 2);
  EXPECT_EQ(drawing.plan.columns(), 3);
  EXPECT_THAT(drawing.plan.passages({0, 0}), ElementsAre(Direction::kEast, Direction::kSouth));
  EXPECT_THAT(drawing.plan.passages({1, 0}), ElementsAre(Direction::kNorth, Direction::kEast));
  EXPECT_THAT(drawing.plan.passages({1, 2}), ElementsAre(Direction::kNorth));
  EXPECT_THAT(drawing.gaps, ElementsAre(MazeEntrance{{1, 0}, Direction::kNorth}));
  EXPECT_FALSE(drawing.hasWall({{1, 0}, Direction::kSouth}));
  EXPECT_TRUE(drawing.hasWall({{1, 0}, Direction::kWest}));
}

TEST(MazeDrawing, wallsComeLineByLine) {
  const MazeDrawing drawing = readDrawing({"+-+ +", "| |  ", "+-+-+"}, "here");
  EXPECT_THAT(drawing.walls(), ElementsAre(MazeWall{{0, 0}, Direction::kNorth}, MazeWall{{0, 0}, Direction::kWest},
                                           MazeWall{{0, 1}, Direction::kWest}, MazeWall{{0, 0}, Direction::kSouth},
                                           MazeWall{{0, 1}, Direction::kSouth}));
  EXPECT_THAT(drawing.gaps,
              ElementsAre(MazeEntrance{{0, 1}, Direction::kSouth}, MazeEntrance{{0, 1}, Direction::kWest}));
}

TEST(MazeDrawing, comesBackTheSame) {
  for (const Lines& lines : {kSmall, Lines{"+ +", "   ", "+ +"}, Lines{"+-+ +", "| |  ", "+-+-+"}}) {
    EXPECT_EQ(linesOf(readDrawing(lines, "here")), lines);
  }
}

TEST(MazeDrawing, saysWhichCharacterIsWrong) {
  const auto expectComplaint = [](const Lines& lines, const std::string& what) {
    EXPECT_THAT([&] { readDrawing(lines, "here"); },
                ThrowsMessage<InputError>(AllOf(HasSubstr("here"), HasSubstr(what))));
  };
  expectComplaint({"+-+", "|x|", "+-+"}, "character 2 of line 2 of the plan must be a cell ' '");
  expectComplaint({"+-+", "- |", "+-+"}, "character 1 of line 2 of the plan must be a wall '|' or a passage ' '");
  expectComplaint({"+|+", "| |", "+-+"}, "character 2 of line 1 of the plan must be a wall '-' or a passage ' '");
  expectComplaint({"+-+", "| |", "+- "}, "character 3 of line 3 of the plan must be a post '+'");
}

TEST(MazeDrawing, anyCharacterCanBeAWall) {
  const MazeDrawing odd = readAnyDrawing({" |+-+", "x|#  ", "+-+- "});
  EXPECT_EQ(linesOf(odd), (Lines{"+-+-+", "| |  ", "+-+-+"}));
}

TEST(MazeDrawing, saysWhichSizeIsWrong) {
  EXPECT_EQ(lineCountFault(3), std::nullopt);
  EXPECT_EQ(lineCountFault(2 * kMaxMazeSide + 1), std::nullopt);
  for (const size_t count : {0, 1, 2, 4, 2 * kMaxMazeSide + 2, 2 * kMaxMazeSide + 3}) {
    EXPECT_THAT(lineCountFault(count).value_or(""), HasSubstr("has " + std::to_string(count) + " lines")) << count;
  }
  EXPECT_EQ(lineLengthFault(kSmall), std::nullopt);
  EXPECT_THAT(lineLengthFault({"+-+", "| ", "+-+"}).value_or(""), HasSubstr("has 2 characters in line 2; they must"));
  EXPECT_THAT(lineLengthFault({"+-+-+", "|  ", "+-+-+"}).value_or(""),
              HasSubstr("has 3 characters in line 2, but 5 in line 1"));
  EXPECT_THAT(lineLengthFault({std::string(131, '+')}).value_or(""), HasSubstr("129 at most"));
}

}  // namespace
}  // namespace ocelli
