#include "analysis/measures/maze_floor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <string_view>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

void check(const ProtocolMaze& maze) {
  const size_t width = maze.plan.empty() ? 0 : maze.plan.front().size();
  bool isMaze = maze.plan.size() >= 3 && maze.plan.size() % 2 == 1 && width >= 3 && width % 2 == 1;
  for (const std::string& line : maze.plan) {
    isMaze = isMaze && line.size() == width && line.find_first_not_of("+-| ") == std::string::npos;
  }
  if (!isMaze) {
    throw InputError("this drawing is not a valid maze", fmt::format("maze \"{}\" of the protocol", maze.name),
                     "the protocol as the study stored it");
  }
}

}  // namespace

MazeFloor::MazeFloor(const ProtocolMaze& maze) : plan_(maze.plan), cellSize_(maze.cellSize) {
  check(maze);
  rows_ = static_cast<int>(plan_.size() / 2);
  columns_ = static_cast<int>(plan_.front().size() / 2);
  const double half = maze.wallThickness / 2;
  for (size_t line = 0; line < plan_.size(); ++line) {
    for (size_t i = 0; i < plan_[line].size(); ++i) {
      const bool isPost = line % 2 == 0 && i % 2 == 0;
      if (plan_[line][i] == ' ' || (line % 2 == 1 && i % 2 == 1)) {
        continue;
      }
      // A wall reaches from post to post.
      const double x = static_cast<double>(i / 2) * cellSize_;
      const double z = static_cast<double>(line / 2) * cellSize_;
      const double east = !isPost && line % 2 == 0 ? cellSize_ : 0;
      const double south = !isPost && i % 2 == 0 ? cellSize_ : 0;
      walls_.push_back({x - half, x + east + half, z - half, z + south + half});
    }
  }
}

bool MazeFloor::contains(const FloorCell& cell) const {
  return cell.row >= 0 && cell.row < rows_ && cell.column >= 0 && cell.column < columns_;
}

std::optional<FloorCell> MazeFloor::cellAt(const FloorPoint& point) const {
  const double column = std::floor(point.x / cellSize_);
  const double row = std::floor(point.z / cellSize_);
  const bool inside = column >= 0 && column < columns_ && row >= 0 && row < rows_;
  return inside ? std::optional(FloorCell{static_cast<int>(row), static_cast<int>(column)}) : std::nullopt;
}

FloorPoint MazeFloor::pointOf(const FloorCell& cell, double east, double south) const {
  return {(cell.column + 0.5 + east) * cellSize_, (cell.row + 0.5 + south) * cellSize_};
}

bool MazeFloor::isOpenToEast(const FloorCell& cell) const {
  return cell.column + 1 < columns_ &&
         plan_[static_cast<size_t>(2 * cell.row + 1)][static_cast<size_t>(2 * cell.column + 2)] == ' ';
}

bool MazeFloor::isOpenToSouth(const FloorCell& cell) const {
  return cell.row + 1 < rows_ &&
         plan_[static_cast<size_t>(2 * cell.row + 2)][static_cast<size_t>(2 * cell.column + 1)] == ' ';
}

std::optional<double> MazeFloor::shortestMeters(const FloorCell& from, const FloorCell& to) const {
  if (!contains(from) || !contains(to)) {
    return std::nullopt;
  }
  std::vector<int> steps(static_cast<size_t>(rows_) * static_cast<size_t>(columns_), -1);
  std::deque<FloorCell> next{from};
  steps[indexOf(from)] = 0;
  while (!next.empty()) {
    const FloorCell cell = next.front();
    next.pop_front();
    if (cell == to) {
      return steps[indexOf(cell)] * cellSize_;
    }
    const auto visit = [&](const FloorCell& other) {
      if (steps[indexOf(other)] < 0) {
        steps[indexOf(other)] = steps[indexOf(cell)] + 1;
        next.push_back(other);
      }
    };
    const FloorCell west{cell.row, cell.column - 1};
    const FloorCell north{cell.row - 1, cell.column};
    if (isOpenToEast(cell)) {
      visit({cell.row, cell.column + 1});
    }
    if (isOpenToSouth(cell)) {
      visit({cell.row + 1, cell.column});
    }
    if (contains(west) && isOpenToEast(west)) {
      visit(west);
    }
    if (contains(north) && isOpenToSouth(north)) {
      visit(north);
    }
  }
  return std::nullopt;
}

bool MazeFloor::meets(const Rectangle& rectangle, const FloorPoint& from, const FloorPoint& to) {
  // The part of the line within both pairs of sides.
  double begin = 0;
  double end = 1;
  const auto clip = [&](double start, double along, double low, double high) {
    if (along == 0) {
      return start >= low && start <= high;
    }
    const double first = (low - start) / along;
    const double second = (high - start) / along;
    begin = std::max(begin, std::min(first, second));
    end = std::min(end, std::max(first, second));
    return begin <= end;
  };
  return clip(from.x, to.x - from.x, rectangle.west, rectangle.east) &&
         clip(from.z, to.z - from.z, rectangle.north, rectangle.south);
}

bool MazeFloor::isClear(const FloorPoint& from, const FloorPoint& to) const {
  return std::none_of(walls_.begin(), walls_.end(), [&](const Rectangle& wall) { return meets(wall, from, to); });
}

std::vector<std::array<double, 4>> wallLines(const ProtocolMaze& maze) {
  std::vector<std::array<double, 4>> lines;
  for (size_t line = 0; line < maze.plan.size(); ++line) {
    for (size_t i = 0; i < maze.plan[line].size(); ++i) {
      const bool level = line % 2 == 0 && i % 2 == 1;
      const bool upright = line % 2 == 1 && i % 2 == 0;
      if (maze.plan[line][i] != ' ' && (level || upright)) {
        const double x = static_cast<double>(i / 2) * maze.cellSize;
        const double z = static_cast<double>(line / 2) * maze.cellSize;
        lines.push_back({x, z, x + (level ? maze.cellSize : 0), z + (upright ? maze.cellSize : 0)});
      }
    }
  }
  return lines;
}

}  // namespace ocelli
