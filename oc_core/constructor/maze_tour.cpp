#include "oc_core/constructor/maze_tour.h"

#include <deque>

#include "oc_core/constructor/maze_options.h"

namespace ocelli {
namespace {

class Walker {
 public:
  Walker(const Maze& maze, TourOrder order) : maze_(maze), order_(order), taken_(maze.cellCount(), false) {}

  std::vector<TourLeg> walk(const MazeCell& start, Direction heading) {
    pending_.push_back({-1, start, heading});
    while (!pending_.empty()) {
      const Way way = pending_.front();
      pending_.pop_front();
      if (!taken_[maze_.indexOf(way.first)]) {
        take(way);
      }
    }
    joinStraightLegs();
    countCells();
    return std::move(legs_);
  }

 private:
  struct Way {
    int parent;
    MazeCell first;
    Direction heading;
  };

  /// Where one can go on from a cell to cells that no leg has.
  std::vector<Direction> waysOn(const MazeCell& cell, Direction heading) const {
    std::vector<Direction> ways;
    for (const Direction way : {leftOf(heading), heading, rightOf(heading)}) {
      if (maze_.isOpen(cell, way) && !taken_[maze_.indexOf(cell.neighbor(way))]) {
        ways.push_back(way);
      }
    }
    return ways;
  }

  void take(const Way& way) {
    TourLeg leg{way.parent, way.heading, {}, {}};
    const int index = static_cast<int>(legs_.size());
    MazeCell at = way.first;
    std::vector<Direction> ways;
    for (;; at = at.neighbor(way.heading)) {
      leg.cells.push_back(at);
      taken_[maze_.indexOf(at)] = true;
      ways = waysOn(at, way.heading);
      if (ways.size() != 1 || ways[0] != way.heading) {
        break;
      }
    }
    legs_.push_back(leg);
    std::vector<Way> next;
    for (const Direction direction : ways) {
      next.push_back({index, at.neighbor(direction), direction});
    }
    pending_.insert(order_ == TourOrder::kBreadthFirst ? pending_.end() : pending_.begin(), next.begin(), next.end());
  }

  /// Where others took the ways to the sides in the meantime, a leg goes on with the one ahead.
  void joinStraightLegs() {
    std::vector<int> newIndex(legs_.size());
    std::vector<TourLeg> joined;
    std::vector<int> childCount(legs_.size(), 0);
    for (const TourLeg& leg : legs_) {
      if (leg.parent >= 0) {
        ++childCount[static_cast<size_t>(leg.parent)];
      }
    }
    for (size_t i = 0; i < legs_.size(); ++i) {
      TourLeg leg = legs_[i];
      const bool first = leg.parent < 0;
      if (!first && childCount[static_cast<size_t>(leg.parent)] == 1 &&
          legs_[static_cast<size_t>(leg.parent)].heading == leg.heading) {
        newIndex[i] = newIndex[static_cast<size_t>(leg.parent)];
        std::vector<MazeCell>& cells = joined[static_cast<size_t>(newIndex[i])].cells;
        cells.insert(cells.end(), leg.cells.begin(), leg.cells.end());
        continue;
      }
      newIndex[i] = static_cast<int>(joined.size());
      if (!first) {
        leg.parent = newIndex[static_cast<size_t>(leg.parent)];
        joined[static_cast<size_t>(leg.parent)].children.push_back(newIndex[i]);
      }
      joined.push_back(leg);
    }
    legs_ = std::move(joined);
  }

  void countCells() {
    for (size_t i = legs_.size(); i-- > 1;) {
      legs_[static_cast<size_t>(legs_[i].parent)].cellsAfter += legs_[i].cells.size() + legs_[i].cellsAfter;
    }
  }

  const Maze& maze_;
  TourOrder order_;
  std::vector<bool> taken_;
  std::deque<Way> pending_;
  std::vector<TourLeg> legs_;
};

}  // namespace

std::vector<TourLeg> tourOf(const Maze& maze, const MazeCell& start, Direction heading, TourOrder order) {
  checkCell(maze, start, "tour of a maze");
  return Walker(maze, order).walk(start, heading);
}

}  // namespace ocelli
