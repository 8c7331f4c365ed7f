// What a simulated observer remembers of a maze: where it has seen ways, and when it last saw which floor.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "study/agent/chance.h"
#include "study/agent/human_factors.h"
#include "study/agent/percept.h"

namespace ocelli {

class MazeMemory {
 public:
  /// Another trial begins: nothing has been seen in it, and some ways are forgotten, each with that chance, over the
  /// number of trials in which it was seen.
  void beginTrial(double forgetting, Random& random);

  void see(const FloorPatch& patch, int64_t now);
  /// A straight line of sight from one place to another: no wall stands between the cells that it crosses.
  void seeAlong(const SeenGrid& grid, const glm::dvec2& from, const glm::dvec2& to);
  /// All of the floor of a cell, as one stands in it.
  void visit(const MazeCell& cell, int64_t now);
  /// One has walked into a wall: whatever it looks like, there is no way in this trial.
  void feelWall(const MazeCell& cell, Direction direction);

  /// What was sought here was seen to move, or to stay.
  void noteMotion(bool moves) { soughtMoves_ = moves; }
  /// As one saw it last, in this trial or one before.
  bool soughtMoves() const { return soughtMoves_; }

  bool knowsWay(const MazeCell& cell, Direction direction) const;
  size_t waysKnown() const { return ways_.size(); }
  /// Whether that patch has been seen, not before `since`.
  bool hasSeen(const FloorPatch& patch, int64_t since) const;
  /// Whether one would have seen an object there: its middle or most of its floor has been seen, not before `since`.
  bool hasSearched(const MazeCell& cell, int64_t since) const;

  struct Way {
    std::vector<MazeCell> cells;  ///< from the first after the start to the goal
    double seconds = 0;
  };
  /// To each cell that known ways lead to, with times for walking a cell and for turning by 90 degrees.
  std::map<MazeCell, Way> waysFrom(const MazeCell& start, double heading, double cellSeconds, double turnSeconds) const;

 private:
  struct Passage {
    MazeCell cell;
    bool east = false;  ///< else south
    auto operator<=>(const Passage&) const = default;
  };
  struct Known {
    int trials = 0;  ///< in which it was seen
    bool seenNow = false;
  };
  void seeWay(const Passage& way);
  static Passage passage(const MazeCell& cell, Direction direction);

  bool soughtMoves_ = false;
  std::map<Passage, Known> ways_;
  std::set<Passage> walls_;                          ///< that were felt
  std::map<MazeCell, std::array<int64_t, 9>> seen_;  ///< when, of each ninth; -1 for never
};

}  // namespace ocelli
