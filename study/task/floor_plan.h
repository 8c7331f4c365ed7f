// Where one can stand in a maze: a disc of the body's radius that slides along walls and posts. The entrance is closed.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/maze/maze_grid.h"
#include "oc_core/scene/maze.h"

namespace ocelli {

class FloorPlan {
 public:
  /// The disc must be narrower than passages.
  FloorPlan(const Maze& maze, double bodyRadius);

  struct Step {
    glm::dvec2 place{0};   ///< (x, z)
    bool touched = false;  ///< a wall or post was in the way
  };
  /// From a place with clearance(), by a step of any length. What leads into a wall is taken away: one slides along it.
  /// The end has clearance() of at least the radius, always.
  Step walk(const glm::dvec2& from, const glm::dvec2& by) const;

  /// From the nearest wall or post to the middle of the disc; 0 within them, and outside of the maze.
  double clearance(const glm::dvec2& place) const;
  double bodyRadius() const { return radius_; }

 private:
  struct Nearest {
    glm::dvec2 point{0};
    double distance = 0;
  };
  /// Of the walls and posts around the place.
  Nearest nearest(const glm::dvec2& place) const;
  bool tryStep(glm::dvec2& place, const glm::dvec2& by) const;

  double radius_;
  double cellSize_;
  glm::dvec2 origin_;
  int rows_;
  int columns_;
  std::vector<std::vector<FloorRectangle>>
      around_;  ///< of each cell: the walls and posts that a disc within it can reach
};

}  // namespace ocelli
