#include "study/task/floor_plan.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// By which the disc is put farther away than it need be: more than rounding, less than anyone sees.
constexpr double kMargin = 1e-9;
constexpr int kMaxPushes = 8;

}  // namespace

FloorPlan::FloorPlan(const Maze& maze, double bodyRadius)
    : radius_(bodyRadius),
      cellSize_(static_cast<double>(maze.cellSize)),
      origin_(static_cast<double>(maze.origin.x), static_cast<double>(maze.origin.z)),
      rows_(maze.rows()),
      columns_(maze.columns()),
      around_(maze.cellCount()) {
  const MazeGrid grid{cellSize_, static_cast<double>(maze.wallThickness), {origin_.x, origin_.y}};
  OC_CHECK(radius_ > 0 && 2 * radius_ < cellSize_ - grid.wallThickness, "a body must fit into passages");
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const MazeCell cell{row, column};
      std::vector<FloorRectangle>& around = around_[maze.indexOf(cell)];
      for (int down = 0; down < 2; ++down) {
        for (int right = 0; right < 2; ++right) {
          around.push_back(grid.postAt(grid.corner(cell, down, right)));
        }
      }
      for (const Direction side : kDirections) {
        if (!maze.isOpen(cell, side)) {
          around.push_back(grid.wallOf(cell, side));
        }
      }
    }
  }
}

FloorPlan::Nearest FloorPlan::nearest(const glm::dvec2& place) const {
  const glm::dvec2 cell = glm::floor((place - origin_) / cellSize_);
  if (!(cell.x >= 0 && cell.y >= 0 && cell.x < columns_ && cell.y < rows_)) {
    return {place, 0};
  }
  // What stands beyond this cell is farther away than its own posts and walls are.
  const auto index = static_cast<size_t>(cell.y) * static_cast<size_t>(columns_) + static_cast<size_t>(cell.x);
  Nearest best{place, std::numeric_limits<double>::infinity()};
  for (const FloorRectangle& wall : around_[index]) {
    const glm::dvec2 point = glm::clamp(place, {wall.west, wall.north}, {wall.east, wall.south});
    const double distance = glm::length(place - point);
    if (distance < best.distance) {
      best = {point, distance};
    }
  }
  return best;
}

double FloorPlan::clearance(const glm::dvec2& place) const {
  return nearest(place).distance;
}

/// Goes on by less than the radius, so that the middle of the disc comes into no wall, and away from what is touched.
bool FloorPlan::tryStep(glm::dvec2& place, const glm::dvec2& by) const {
  glm::dvec2 next = place + by;
  Nearest wall = nearest(next);
  const bool touched = wall.distance < radius_;
  for (int push = 0; push < kMaxPushes && wall.distance < radius_ && wall.distance > 0; ++push) {
    next = wall.point + (next - wall.point) * (radius_ * (1 + kMargin) / wall.distance);
    wall = nearest(next);
  }
  if (wall.distance >= radius_) {
    place = next;
  }
  return touched;
}

FloorPlan::Step FloorPlan::walk(const glm::dvec2& from, const glm::dvec2& by) const {
  Step step{from, false};
  const double length = glm::length(by);
  if (!(length > 0)) {
    return step;
  }
  const double parts = std::max(1.0, std::ceil(length / (radius_ / 2)));
  for (double part = 0; part < parts; ++part) {
    step.touched = tryStep(step.place, by / parts) || step.touched;
  }
  return step;
}

}  // namespace ocelli
