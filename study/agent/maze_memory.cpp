#include "study/agent/maze_memory.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <queue>
#include <tuple>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr std::array<int64_t, 9> kNeverSeen{-1, -1, -1, -1, -1, -1, -1, -1, -1};
/// Of nine: whatever stands in a cell is about as large as one of them.
constexpr int kEnough = 5;
constexpr size_t kMiddle = 4;

double headingOf(Direction direction) {
  return static_cast<double>(direction) * kPi / 2;
}

}  // namespace

MazeMemory::Passage MazeMemory::passage(const MazeCell& cell, Direction direction) {
  switch (direction) {
    case Direction::kEast:
      return {cell, true};
    case Direction::kSouth:
      return {cell, false};
    case Direction::kWest:
      return {cell.neighbor(Direction::kWest), true};
    case Direction::kNorth:
      return {cell.neighbor(Direction::kNorth), false};
  }
  return {cell, false};
}

void MazeMemory::beginTrial(double forgetting, Random& random) {
  seen_.clear();
  walls_.clear();
  for (auto way = ways_.begin(); way != ways_.end();) {
    way->second.seenNow = false;
    way = happens(random, forgetting / std::max(way->second.trials, 1)) ? ways_.erase(way) : std::next(way);
  }
}

void MazeMemory::seeWay(const Passage& way) {
  if (walls_.contains(way)) {
    return;
  }
  Known& known = ways_[way];
  known.trials += known.seenNow ? 0 : 1;
  known.seenNow = true;
}

void MazeMemory::seeAlong(const SeenGrid& grid, const glm::dvec2& from, const glm::dvec2& to) {
  constexpr double kStepShare = 0.02;  // of a cell
  const auto steps = static_cast<int>(glm::distance(from, to) / (kStepShare * grid.cellSize)) + 1;
  MazeCell last = grid.cellAt(from);
  for (int i = 1; i <= steps; ++i) {
    const MazeCell cell = grid.cellAt(glm::mix(from, to, static_cast<double>(i) / steps));
    for (const Direction direction : kDirections) {
      if (last.neighbor(direction) == cell) {
        seeWay(passage(last, direction));
      }
    }
    last = cell;
  }
}

void MazeMemory::see(const FloorPatch& patch, int64_t now) {
  if (patch.way) {
    seeWay(passage(patch.cell, *patch.way));
  } else {
    seen_.try_emplace(patch.cell, kNeverSeen).first->second[static_cast<size_t>(patch.ninth)] = now;
  }
}

void MazeMemory::visit(const MazeCell& cell, int64_t now) {
  seen_[cell].fill(now);
}

void MazeMemory::feelWall(const MazeCell& cell, Direction direction) {
  ways_.erase(passage(cell, direction));
  walls_.insert(passage(cell, direction));
}

bool MazeMemory::knowsWay(const MazeCell& cell, Direction direction) const {
  return ways_.contains(passage(cell, direction));
}

bool MazeMemory::hasSeen(const FloorPatch& patch, int64_t since) const {
  if (patch.way) {
    return ways_.contains(passage(patch.cell, *patch.way));
  }
  const auto found = seen_.find(patch.cell);
  return found != seen_.end() && found->second[static_cast<size_t>(patch.ninth)] >= std::max<int64_t>(since, 0);
}

bool MazeMemory::hasSearched(const MazeCell& cell, int64_t since) const {
  const auto found = seen_.find(cell);
  if (found == seen_.end()) {
    return false;
  }
  const auto isSeen = [&](int64_t time) { return time >= std::max<int64_t>(since, 0); };
  return isSeen(found->second[kMiddle]) || std::count_if(found->second.begin(), found->second.end(), isSeen) >= kEnough;
}

std::map<MazeCell, MazeMemory::Way> MazeMemory::waysFrom(const MazeCell& start, double heading, double cellSeconds,
                                                         double turnSeconds) const {
  // Dijkstra's algorithm over cells and the directions from which they are entered.
  struct State {
    MazeCell cell;
    int direction = 0;  ///< that one looks in; kDirections.size() at the start
    auto operator<=>(const State&) const = default;
  };
  using Entry = std::tuple<double, State, State>;  // when, where, from where
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::map<State, State> before;
  std::map<MazeCell, Way> ways;
  const State first{start, static_cast<int>(kDirections.size())};
  open.push({0, first, first});
  while (!open.empty()) {
    const auto [seconds, state, from] = open.top();
    open.pop();
    if (!before.emplace(state, from).second) {
      continue;
    }
    if (!ways.contains(state.cell)) {
      Way& way = ways[state.cell];
      way.seconds = seconds;
      for (State at = state; at != first; at = before.at(at)) {
        way.cells.insert(way.cells.begin(), at.cell);
      }
    }
    for (const Direction direction : kDirections) {
      if (knowsWay(state.cell, direction)) {
        const double now = state == first ? heading : static_cast<double>(state.direction) * kPi / 2;
        const double turn = std::abs(std::remainder(headingOf(direction) - now, 2 * kPi)) / (kPi / 2);
        open.push({seconds + cellSeconds + turn * turnSeconds,
                   {state.cell.neighbor(direction), static_cast<int>(direction)},
                   state});
      }
    }
  }
  return ways;
}

}  // namespace ocelli
