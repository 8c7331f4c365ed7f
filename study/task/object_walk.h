// Objects that walk through a maze from the middle of one cell to that of the next, in random directions
// (section 7.4.2: they "translate around the map in random directions").
//
// All of them set out and arrive at the same time. None goes into a cell that another stands in or goes to, so that two
// never meet; where that leaves no way, one waits. They turn back where there is no other way, and never leave the
// maze.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "oc_core/base/random.h"
#include "study/task/task.h"

namespace ocelli {

class ObjectWalk {
 public:
  struct Start {
    MazeCell cell;
    glm::dvec2 place{0};  ///< (x, z) within it
  };
  /// `maze` must outlive it. Speeds are rounded such that a way takes whole ticks. Starts lie in cells of their own.
  ObjectWalk(const Maze& maze, std::span<const Start> starts, double metersPerSecond, uint64_t seed);

  void advance();
  size_t size() const { return walks_.size(); }
  /// (x, z).
  glm::dvec2 place(size_t object) const;
  const MazeCell& goal(size_t object) const { return walks_[object].goal; }

 private:
  struct Walk {
    MazeCell cell;  ///< from which it comes
    MazeCell goal;
    glm::dvec2 from{0};
    glm::dvec2 to{0};
    std::optional<Direction> heading{};
  };
  void chooseGoals();

  const Maze& maze_;
  Random random_;
  int64_t ticksOfWay_;
  int64_t tick_ = 0;  ///< of the way
  std::vector<Walk> walks_;
};

}  // namespace ocelli
