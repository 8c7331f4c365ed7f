#include "study/task/maze_path.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"
#include "study/task/task_fields.h"

namespace ocelli {
namespace {

constexpr int kMaxTries = 200;  // to find a path that comes into no cell twice

Direction turned(Direction heading, char turn) {
  return turn == 'L' ? leftOf(heading) : rightOf(heading);
}

glm::dvec2 wayOf(Direction heading) {
  const glm::vec3 way = vectorOf(heading);
  return {static_cast<double>(way.x), static_cast<double>(way.z)};
}

bool visitsTwice(const MazePath& path) {
  std::set<MazeCell> visited{path.start};
  MazeCell cell = path.start;
  Direction heading = path.heading;
  for (size_t leg = 0; leg < path.legs.size(); ++leg) {
    for (int step = 0; step < path.legs[leg]; ++step) {
      cell = cell.neighbor(heading);
      if (!visited.insert(cell).second) {
        return true;
      }
    }
    heading = leg < path.turns.size() ? turned(heading, path.turns[leg]) : heading;
  }
  return false;
}

}  // namespace

glm::dvec2 groundCenter(const Maze& maze, const MazeCell& cell) {
  const glm::vec3 center = maze.centerOf(cell);
  return {static_cast<double>(center.x), static_cast<double>(center.z)};
}

/// How many paths of one sequence of turns go on from somewhere: of a leg, from a cell, in a heading, with so many
/// steps left, of which the next one is on that leg.
class MazePaths::Counts {
 public:
  Counts(const Maze& maze, const std::string& turns, int maxSteps)
      : maze_(maze),
        turns_(turns),
        perStep_((turns.size() + 1) * maze.cellCount() * 4),
        counts_(perStep_ * (static_cast<size_t>(maxSteps) + 1), 0) {
    for (int steps = 1; steps <= maxSteps; ++steps) {
      for (size_t leg = 0; leg <= turns.size(); ++leg) {
        for (int row = 0; row < maze.rows(); ++row) {
          for (int column = 0; column < maze.columns(); ++column) {
            for (const Direction heading : kDirections) {
              const MazeCell cell{row, column};
              if (maze.isOpen(cell, heading)) {
                const MazeCell next = cell.neighbor(heading);
                counts_[index(leg, cell, heading, steps)] =
                    ended(leg, next, heading, steps - 1) + at(leg, next, heading, steps - 1);
              }
            }
          }
        }
      }
    }
  }

  double at(size_t leg, const MazeCell& cell, Direction heading, int steps) const {
    return counts_[index(leg, cell, heading, steps)];
  }
  /// Where a leg ends in a cell.
  double ended(size_t leg, const MazeCell& cell, Direction heading, int steps) const {
    return leg == turns_.size() ? (steps == 0 ? 1 : 0) : at(leg + 1, cell, turned(heading, turns_[leg]), steps);
  }

 private:
  size_t index(size_t leg, const MazeCell& cell, Direction heading, int steps) const {
    return static_cast<size_t>(steps) * perStep_ + (leg * maze_.cellCount() + maze_.indexOf(cell)) * 4 +
           static_cast<size_t>(heading);
  }

  const Maze& maze_;
  const std::string& turns_;
  size_t perStep_;
  std::vector<double> counts_;
};

std::optional<MazePath> MazePaths::random(const std::string& turns, Random& random) const {
  struct Begin {
    MazeCell cell;
    Direction heading;
    int steps;
    double until;  ///< counts of this one and all before
  };
  const Counts counts(maze_, turns, maxSteps_);
  std::vector<Begin> begins;
  double all = 0;
  for (int steps = minSteps_; steps <= maxSteps_; ++steps) {
    for (int row = 0; row < maze_.rows(); ++row) {
      for (int column = 0; column < maze_.columns(); ++column) {
        for (const Direction heading : kDirections) {
          const double count = counts.at(0, {row, column}, heading, steps);
          if (count > 0) {
            all += count;
            begins.push_back({{row, column}, heading, steps, all});
          }
        }
      }
    }
  }
  if (begins.empty()) {
    return std::nullopt;
  }
  const auto share = [&] { return static_cast<double>(random.next() >> 11) * 0x1p-53; };
  MazePath path;
  for (int tries = 0; tries < kMaxTries; ++tries) {
    const double drawn = share() * all;
    const auto begin = std::min(std::upper_bound(begins.begin(), begins.end(), drawn,
                                                 [](double value, const Begin& each) { return value < each.until; }),
                                begins.end() - 1);
    path = {begin->cell, begin->heading, {0}, turns};
    MazeCell cell = begin->cell;
    Direction heading = begin->heading;
    for (int steps = begin->steps; steps > 0; --steps) {
      const size_t leg = path.legs.size() - 1;
      cell = cell.neighbor(heading);
      ++path.legs.back();
      const double ends = counts.ended(leg, cell, heading, steps - 1);
      const double goesOn = counts.at(leg, cell, heading, steps - 1);
      if (leg < turns.size() && share() * (ends + goesOn) < ends) {
        heading = turned(heading, turns[leg]);
        path.legs.push_back(0);
      }
    }
    OC_CHECK(path.legs.size() == turns.size() + 1, "a random path makes all its turns");
    if (!visitsTwice(path)) {
      break;
    }
  }
  return path;
}

bool MazePaths::exists(const std::string& turns) const {
  Random unused(1);
  return random(turns, unused).has_value();
}

std::vector<std::string> MazePaths::sequences(int turns) const {
  std::vector<std::string> found;
  for (unsigned bits = 0; bits < 1u << turns; ++bits) {
    std::string sequence;
    for (int i = 0; i < turns; ++i) {
      sequence += (bits >> i & 1u) != 0 ? 'R' : 'L';
    }
    if (exists(sequence)) {
      found.push_back(sequence);
    }
  }
  return found;
}

std::vector<glm::dvec2> mapOf(const MazePath& path, const Maze& maze) {
  // North up, whatever the first heading is: so it is as if one had set out to the north.
  std::vector<glm::dvec2> corners{{0, 0}};
  Direction heading = Direction::kNorth;
  for (size_t leg = 0; leg < path.legs.size(); ++leg) {
    corners.push_back(corners.back() +
                      wayOf(heading) * (static_cast<double>(path.legs[leg]) * static_cast<double>(maze.cellSize)));
    heading = leg < path.turns.size() ? turned(heading, path.turns[leg]) : heading;
  }
  return corners;
}

PathWalk::PathWalk(const MazePath& path, const Maze& maze, const Speed& speed) {
  const double cell = static_cast<double>(maze.cellSize);
  const double radius = cell / 2;  // the turns of two neighbouring cells follow one another
  const double turnSeconds = std::max(kPi / 2 * radius / speed.metersPerSecond, 90 / speed.turnDegreesPerSecond);
  glm::dvec2 place = groundCenter(maze, path.start);
  Direction heading = path.heading;
  for (size_t leg = 0; leg < path.legs.size(); ++leg) {
    const bool turnsAfter = leg < path.turns.size();
    const glm::dvec2 along = wayOf(heading);
    const double length = path.legs[leg] * cell - (leg > 0 ? radius : 0) - (turnsAfter ? radius : 0);
    if (length > 0) {
      pieces_.push_back({seconds_, length / speed.metersPerSecond, place, along, along, radiansOf(heading), 0, length});
      seconds_ += pieces_.back().lasts;
      place += along * length;
    }
    if (turnsAfter) {
      const Direction next = turned(heading, path.turns[leg]);
      const double angle = path.turns[leg] == 'L' ? -kPi / 2 : kPi / 2;
      pieces_.push_back({seconds_, turnSeconds, place, along, wayOf(next), radiansOf(heading), angle, radius});
      seconds_ += turnSeconds;
      place += (along + wayOf(next)) * radius;
      heading = next;
    }
  }
}

WalkerPose PathWalk::at(double seconds) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), seconds,
                                      [](double value, const Piece& piece) { return value < piece.begins; });
  const Piece& piece = after == pieces_.begin() ? *after : *(after - 1);
  const double share = std::clamp((seconds - piece.begins) / piece.lasts, 0.0, 1.0);
  if (piece.turnRadians == 0) {
    const glm::dvec2 place = piece.from + piece.along * (piece.length * share);
    return {place.x, place.y, piece.heading};
  }
  const double angle = kPi / 2 * share;
  const glm::dvec2 place =
      piece.from + piece.length * (piece.towards * (1 - std::cos(angle)) + piece.along * std::sin(angle));
  return {place.x, place.y, std::remainder(piece.heading + piece.turnRadians * share, 2 * kPi)};
}

double PathWalk::secondsOf(int steps, int turns, const Maze& maze, const Speed& speed) {
  MazePath path;
  path.legs.assign(static_cast<size_t>(turns) + 1, 1);
  path.legs.back() += steps - turns - 1;
  path.turns.assign(static_cast<size_t>(turns), 'L');
  return PathWalk(path, maze, speed).seconds();
}

}  // namespace ocelli
