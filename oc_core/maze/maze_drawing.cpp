#include "oc_core/maze/maze_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr char kPost = '+';
constexpr char kEastWestWall = '-';
constexpr char kNorthSouthWall = '|';
constexpr char kFree = ' ';
constexpr size_t kMaxLines = 2 * kMaxMazeSide + 1;

bool isLength(size_t length) {
  return length >= 3 && length % 2 == 1 && length <= kMaxLines;
}

/// Line and character of a wall.
std::array<size_t, 2> placeOf(const MazeWall& wall) {
  const CellStep step = stepOf(wall.side);
  return {static_cast<size_t>(2 * wall.cell.row + 1 + step.rows),
          static_cast<size_t>(2 * wall.cell.column + 1 + step.columns)};
}

void checkCharacters(const std::vector<std::string>& lines, const std::string& where) {
  const auto expect = [&](size_t line, size_t i, std::string_view allowed, const char* what) {
    if (allowed.find(lines[line][i]) == std::string_view::npos) {
      throw InputError(fmt::format("character {} of line {} of the plan must be {}", i + 1, line + 1, what), where,
                       "draw posts as +, walls as - and |, passages and cells as spaces");
    }
  };
  for (size_t line = 0; line < lines.size(); ++line) {
    for (size_t i = 0; i < lines[line].size(); ++i) {
      if (line % 2 == 0 && i % 2 == 0) {
        expect(line, i, "+", "a post '+'");
      } else if (line % 2 == 1 && i % 2 == 1) {
        expect(line, i, " ", "a cell ' '");
      } else if (line % 2 == 0) {
        expect(line, i, "- ", "a wall '-' or a passage ' '");
      } else {
        expect(line, i, "| ", "a wall '|' or a passage ' '");
      }
    }
  }
}

}  // namespace

bool MazeDrawing::hasWall(const MazeWall& wall) const {
  if (plan.contains(wall.cell.neighbor(wall.side))) {
    return !plan.isOpen(wall.cell, wall.side);
  }
  return std::find(gaps.begin(), gaps.end(), MazeEntrance{wall.cell, opposite(wall.side)}) == gaps.end();
}

std::vector<MazeWall> MazeDrawing::walls() const {
  std::vector<MazeWall> list;
  const auto add = [&](const MazeWall& wall) {
    if (hasWall(wall)) {
      list.push_back(wall);
    }
  };
  const int rows = plan.rows();
  const int columns = plan.columns();
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      add(row < rows ? MazeWall{{row, column}, Direction::kNorth} : MazeWall{{row - 1, column}, Direction::kSouth});
    }
    for (int column = 0; row < rows && column <= columns; ++column) {
      add(column < columns ? MazeWall{{row, column}, Direction::kWest} : MazeWall{{row, column - 1}, Direction::kEast});
    }
  }
  return list;
}

std::optional<std::string> lineCountFault(size_t count) {
  if (isLength(count)) {
    return std::nullopt;
  }
  return fmt::format("has {} lines; it must have two for each row of cells and one more, {} at most", count, kMaxLines);
}

std::optional<std::string> lineLengthFault(const std::vector<std::string>& lines) {
  for (size_t line = 0; line < lines.size(); ++line) {
    const size_t width = lines[line].size();
    if (!isLength(width)) {
      return fmt::format(
          "has {} characters in line {}; they must be two for each column of cells and one more, {} at most", width,
          line + 1, kMaxLines);
    }
    if (width != lines.front().size()) {
      return fmt::format("has {} characters in line {}, but {} in line 1", width, line + 1, lines.front().size());
    }
  }
  return std::nullopt;
}

MazeDrawing readDrawing(const std::vector<std::string>& lines, const std::string& where) {
  checkCharacters(lines, where);
  return readAnyDrawing(lines);
}

MazeDrawing readAnyDrawing(const std::vector<std::string>& lines) {
  OC_CHECK(!lineCountFault(lines.size()) && !lineLengthFault(lines), "who reads a drawing checks its size");
  MazeDrawing drawing{MazePlan(static_cast<int>(lines.size() / 2), static_cast<int>(lines.front().size() / 2))};
  MazePlan& plan = drawing.plan;
  for (int row = 0; row < plan.rows(); ++row) {
    for (int column = 0; column < plan.columns(); ++column) {
      const MazeCell cell{row, column};
      for (const Direction side : kDirections) {
        const auto [line, i] = placeOf({cell, side});
        const bool open = lines[line][i] == kFree;
        if (plan.contains(cell.neighbor(side))) {
          plan.setOpen(cell, side, open);
        } else if (open) {
          drawing.gaps.push_back({cell, opposite(side)});
        }
      }
    }
  }
  return drawing;
}

std::vector<std::string> linesOf(const MazeDrawing& drawing) {
  const auto rows = static_cast<size_t>(drawing.plan.rows());
  const auto columns = static_cast<size_t>(drawing.plan.columns());
  std::vector<std::string> lines(2 * rows + 1, std::string(2 * columns + 1, kFree));
  for (size_t line = 0; line < lines.size(); line += 2) {
    for (size_t i = 0; i < lines[line].size(); i += 2) {
      lines[line][i] = kPost;
    }
  }
  for (const MazeWall& wall : drawing.walls()) {
    const auto [line, i] = placeOf(wall);
    lines[line][i] = isEastWest(wall.side) ? kNorthSouthWall : kEastWestWall;
  }
  return lines;
}

}  // namespace ocelli
