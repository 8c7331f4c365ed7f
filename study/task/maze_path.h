// Random paths through a maze with a given number of turns (section 7.3.3), and how one walks along them.
//
// A path goes from the middle of one cell to that of another; it never turns back, and takes one step at least between
// two turns. All paths of one sequence of turns are equally likely, but that one which comes into no cell twice is
// taken where some are found.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/random.h"
#include "study/task/task.h"

namespace ocelli {

struct MazePath {
  MazeCell start;
  Direction heading = Direction::kNorth;
  std::vector<int> legs{};  ///< steps, from cell to cell; one more than turns
  std::string turns{};      ///< "LRRLR"
};

/// Of 1 to kMaxPathTurns turns.
inline constexpr int kMaxPathTurns = 6;
inline constexpr size_t kMaxPathCells = 400;  ///< of the maze

/// (x, z).
glm::dvec2 groundCenter(const Maze& maze, const MazeCell& cell);

class MazePaths {
 public:
  /// Paths of that many steps. `maze` must outlive it.
  MazePaths(const Maze& maze, int minSteps, int maxSteps) : maze_(maze), minSteps_(minSteps), maxSteps_(maxSteps) {}

  /// A path with these turns; nothing where there is none.
  std::optional<MazePath> random(const std::string& turns, Random& random) const;
  bool exists(const std::string& turns) const;
  /// All sequences of so many turns that some path has.
  std::vector<std::string> sequences(int turns) const;

 private:
  class Counts;

  const Maze& maze_;
  int minSteps_;
  int maxSteps_;
};

/// The corners of a path, from the start to the end, in metres: x to the right of the first heading, y back from it, as
/// a map shows it whose start points up.
std::vector<glm::dvec2> mapOf(const MazePath& path, const Maze& maze);

/// Along a path at a steady speed, around corners on a quarter of a circle, not faster than one may turn.
class PathWalk {
 public:
  struct Speed {
    double metersPerSecond = 1.5;
    double turnDegreesPerSecond = 90;
  };
  PathWalk(const MazePath& path, const Maze& maze, const Speed& speed);

  double seconds() const { return seconds_; }
  WalkerPose at(double seconds) const;

  /// Of a path with so many steps and turns.
  static double secondsOf(int steps, int turns, const Maze& maze, const Speed& speed);

 private:
  struct Piece {
    double begins = 0;  ///< seconds
    double lasts = 0;
    glm::dvec2 from{0};
    glm::dvec2 along{0};     ///< unit; into it
    glm::dvec2 towards{0};   ///< of a turn: unit; out of it
    double heading = 0;      ///< into it
    double turnRadians = 0;  ///< clockwise; 0 for a straight piece
    double length = 0;       ///< of a straight piece, or the radius of a turn
  };
  std::vector<Piece> pieces_;
  double seconds_ = 0;
};

}  // namespace ocelli
