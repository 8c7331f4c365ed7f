#include "oc_core/constructor/maze_openings.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

bool hasOpenings(const Maze& maze, const MazeCell& cell) {
  const CellKind kind = maze.kind(cell);
  return kind == CellKind::kTurn || kind == CellKind::kThreeWay || kind == CellKind::kFourWay;
}

bool isBefore(const Portal& opening, const glm::vec3& eye) {
  return glm::dot(opening.normal, eye - opening.center) > 0;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// Directions in the plan, (x, z): those from `left` clockwise, as seen from above, to `right`.
struct Fan {
  glm::dvec2 left;
  glm::dvec2 right;

  bool empty() const { return cross(left, right) <= 0; }
};

/// Walks from the eye's cell through every opening that the fan of sight lines still passes.
class SightLines {
 public:
  SightLines(const Maze& maze, const glm::vec3& eye) : maze_(maze), eye_(eye) {}

  void visit(const MazeCell& cell, const Fan* fan) {
    for (const Direction direction : maze_.passages(cell)) {
      const Portal opening = maze_.openingOf(cell, direction);
      const MazeCell next = cell.neighbor(direction);
      Fan passed = through(opening);
      if (isBefore(opening, eye_)) {
        passed = fan != nullptr ? narrowed(*fan, passed) : passed;
        if (passed.empty()) {
          continue;
        }
        if (hasOpenings(maze_, cell)) {
          seen.push_back(opening);
        }
      } else if (fan != nullptr) {
        continue;  // it leads back
      }
      // The far side of the same passage, seen along the way. The eye may stand in between.
      Portal far = maze_.openingOf(next, opposite(direction));
      far.normal = -far.normal;
      far.halfRight = -far.halfRight;
      if (isBefore(far, eye_)) {
        passed = isBefore(opening, eye_) ? narrowed(passed, through(far)) : through(far);
        if (!passed.empty()) {
          visit(next, &passed);
        }
      }
    }
  }

  std::vector<Portal> seen;

 private:
  glm::dvec2 towards(const glm::vec3& point) const {
    return {static_cast<double>(point.x) - static_cast<double>(eye_.x),
            static_cast<double>(point.z) - static_cast<double>(eye_.z)};
  }
  Fan through(const Portal& opening) const {
    return {towards(opening.center - opening.halfRight), towards(opening.center + opening.halfRight)};
  }
  static Fan narrowed(const Fan& fan, const Fan& by) {
    return {cross(fan.left, by.left) > 0 ? by.left : fan.left, cross(by.right, fan.right) > 0 ? by.right : fan.right};
  }

  const Maze& maze_;
  glm::vec3 eye_;
};

}  // namespace

std::vector<Portal> openingsInSight(const Maze& maze, const glm::vec3& eye) {
  const bool between = eye.y <= maze.origin.y + maze.wallHeight;
  if (between && maze.isInWall(eye)) {
    throw InputError("the eye stands in a wall of the maze", "view, \"eye\"", "move it into a corridor");
  }
  const std::optional<MazeCell> start = maze.cellAt(eye);
  if (between && start) {
    SightLines lines(maze, eye);
    lines.visit(*start, nullptr);
    return lines.seen;
  }
  std::vector<Portal> openings;
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      const MazeCell cell{row, column};
      for (const Direction direction : hasOpenings(maze, cell) ? maze.passages(cell) : std::vector<Direction>{}) {
        const Portal opening = maze.openingOf(cell, direction);
        if (isBefore(opening, eye)) {
          openings.push_back(opening);
        }
      }
    }
  }
  return openings;
}

}  // namespace ocelli
