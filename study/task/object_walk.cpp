#include "study/task/object_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "study/task/maze_path.h"

namespace ocelli {
ObjectWalk::ObjectWalk(const Maze& maze, std::span<const Start> starts, double metersPerSecond, uint64_t seed)
    : maze_(maze),
      random_(seed),
      ticksOfWay_(std::max<int64_t>(1, std::llround(static_cast<double>(maze.cellSize) / metersPerSecond *
                                                    static_cast<double>(kTicksPerSecond)))) {
  for (const Start& start : starts) {
    walks_.push_back({start.cell, start.cell, start.place, start.place});
  }
  chooseGoals();
}

void ObjectWalk::chooseGoals() {
  for (Walk& walk : walks_) {
    walk.cell = walk.goal;
  }
  const auto isFree = [&](const MazeCell& cell) {
    return std::none_of(walks_.begin(), walks_.end(),
                        [&](const Walk& other) { return other.cell == cell || other.goal == cell; });
  };
  for (Walk& walk : walks_) {
    std::vector<Direction> ways = maze_.passages(walk.cell);
    std::erase_if(ways, [&](Direction way) { return !isFree(walk.cell.neighbor(way)); });
    if (walk.heading && ways.size() > 1) {
      std::erase(ways, opposite(*walk.heading));
    }
    walk.from = walk.to;
    if (!ways.empty()) {
      walk.heading = ways[random_.below(ways.size())];
      walk.goal = walk.cell.neighbor(*walk.heading);
      walk.to = groundCenter(maze_, walk.goal);
    }
  }
}

void ObjectWalk::advance() {
  if (++tick_ >= ticksOfWay_) {
    tick_ = 0;
    chooseGoals();
  }
}

glm::dvec2 ObjectWalk::place(size_t object) const {
  const Walk& walk = walks_[object];
  return glm::mix(walk.from, walk.to, static_cast<double>(tick_) / static_cast<double>(ticksOfWay_));
}

}  // namespace ocelli
