// The drawing of a maze, as files and protocols hold it (docs/files.md):
//
//   +-+-+-+
//   |     |      Line 2r + 1, character 2c + 1 is the cell in row r, column c. Beside it, `|` and `-` are walls and a
//   + +-+ +      space is a passage; a space in the outer wall is a gap there, such as the entrance. Posts, `+`, always
//   |   | |      stand.
//   +-+-+ +
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/maze/maze_plan.h"

namespace ocelli {

/// A gap in the outer wall.
struct MazeEntrance {
  MazeCell cell;
  Direction heading = Direction::kNorth;  ///< in which one walks in; the gap is on the opposite side of the cell

  bool operator==(const MazeEntrance&) const = default;
};

/// One side of a cell.
struct MazeWall {
  MazeCell cell;
  Direction side = Direction::kNorth;

  bool operator==(const MazeWall&) const = default;
};

/// What a drawing says.
struct MazeDrawing {
  MazePlan plan;
  std::vector<MazeEntrance> gaps{};  ///< by cell, row by row, then by side: north, east, south, west

  /// Whether a wall is drawn there.
  bool hasWall(const MazeWall& wall) const;
  /// Those that are drawn, each once, line by line of the drawing.
  std::vector<MazeWall> walls() const;
};

/// What is wrong with the number of lines, or with their lengths: "has 2 lines; it must ...". Nothing where they can be
/// the drawing of a maze of 1 to kMaxMazeSide rows and columns.
std::optional<std::string> lineCountFault(size_t count);
std::optional<std::string> lineLengthFault(const std::vector<std::string>& lines);

/// The lines must have neither fault. Throws InputError that names `where` and the first character that is not one of
/// those above, by line and column.
MazeDrawing readDrawing(const std::vector<std::string>& lines, const std::string& where);
/// The same for any characters: all but a space is a wall where a wall can be, and means nothing elsewhere.
MazeDrawing readAnyDrawing(const std::vector<std::string>& lines);

/// Reading them gives the same drawing again.
std::vector<std::string> linesOf(const MazeDrawing& drawing);

}  // namespace ocelli
