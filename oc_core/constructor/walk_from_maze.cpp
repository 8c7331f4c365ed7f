#include "oc_core/constructor/walk_from_maze.h"

#include <algorithm>
#include <map>

namespace ocelli {
namespace {

class MazeWalk {
 public:
  explicit MazeWalk(const Maze& maze) : maze_(maze), clear_(maze.cellSize - maze.wallThickness) {}

  WalkMap map() {
    for (int row = 0; row < maze_.rows(); ++row) {
      for (int column = 0; column < maze_.columns(); ++column) {
        const MazeCell cell{row, column};
        if (maze_.kind(cell) != CellKind::kStraight) {
          addRoom(cell);
        }
      }
    }
    // Every corridor ends in a turn, a crossing or a dead end.
    const std::map<MazeCell, uint32_t> rooms = roomOf_;
    for (const auto& [cell, room] : rooms) {
      for (const Direction way : maze_.passages(cell)) {
        addWay(cell, way);
      }
    }
    numberCells(map_);
    return std::move(map_);
  }

 private:
  void addRoom(const MazeCell& cell) {
    WalkCell room;
    room.center = maze_.centerOf(cell);
    room.halfLength = clear_ / 2;
    room.halfWidth = clear_ / 2;
    room.height = maze_.wallHeight;
    roomOf_[cell] = static_cast<uint32_t>(map_.cells.size());
    map_.cells.push_back(room);
  }

  /// Over all of its cells, from the middle of one passage to that of the other.
  uint32_t addTunnel(const std::vector<MazeCell>& cells, Direction heading) {
    WalkCell tunnel;
    tunnel.kind = WalkCellKind::kTunnel;
    tunnel.center = (maze_.centerOf(cells.front()) + maze_.centerOf(cells.back())) / 2.0f;
    tunnel.axis = vectorOf(heading);
    tunnel.halfLength = maze_.cellSize * static_cast<float>(cells.size()) / 2;
    tunnel.halfWidth = clear_ / 2;
    tunnel.height = maze_.wallHeight;
    for (const float along : {0.0f, 2 * tunnel.halfLength}) {
      tunnel.rings.push_back({along, clear_ / 2, clear_ / 2, maze_.wallHeight});
    }
    for (const MazeCell& cell : cells) {
      roomOf_[cell] = static_cast<uint32_t>(map_.cells.size());
    }
    map_.cells.push_back(tunnel);
    return static_cast<uint32_t>(map_.cells.size() - 1);
  }

  /// Of `from`, a cell at its border, on the side `way`, in the middle of the passage.
  void addPortal(uint32_t from, uint32_t to, const MazeCell& cell, Direction way) {
    Portal opening = maze_.openingOf(cell, way);
    opening.center += vectorOf(way) * (maze_.wallThickness / 2);
    map_.portals.push_back({from, to, opening});
  }

  void addWay(const MazeCell& cell, Direction way) {
    const MazeCell next = cell.neighbor(way);
    const uint32_t from = roomOf_.at(cell);
    if (maze_.kind(next) != CellKind::kStraight) {
      if (way == Direction::kSouth || way == Direction::kEast) {
        addPortal(from, roomOf_.at(next), cell, way);
      }
      return;
    }
    std::vector<MazeCell> cells = maze_.ahead(cell, way);
    if (roomOf_.contains(cells.front())) {
      return;  // it was met from its other end
    }
    const uint32_t to = roomOf_.at(cells.back());
    cells.pop_back();
    const uint32_t tunnel = addTunnel(cells, way);
    addPortal(from, tunnel, cell, way);
    addPortal(tunnel, to, cells.back(), way);
  }

  const Maze& maze_;
  float clear_;
  WalkMap map_;
  std::map<MazeCell, uint32_t> roomOf_;
};

}  // namespace

WalkMap walkMapOf(const Maze& maze) {
  return MazeWalk(maze).map();
}

}  // namespace ocelli
