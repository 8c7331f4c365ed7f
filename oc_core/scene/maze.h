// A grid maze: rows x columns of square cells with walls between some of them, one entrance, and landmarks.
//
// The plan. Row 0 lies in the north, column 0 in the west; x runs to the east, z to the south, y up. The floor is at
// the height of `origin`, which is the outer corner of the north-west: the middle line of the outer walls. Walls stand
// on the lines between cells, half of their thickness on either side, and a post of the same thickness stands at every
// corner of the grid. So every passage is as wide as a cell less one wall.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/scene/mesh.h"
#include "oc_core/scene/portal.h"

namespace ocelli {

inline constexpr int kMaxMazeSide = 64;  ///< rows or columns

enum class Direction : uint8_t { kNorth, kEast, kSouth, kWest };
inline constexpr std::array<Direction, 4> kDirections{Direction::kNorth, Direction::kEast, Direction::kSouth,
                                                      Direction::kWest};

Direction leftOf(Direction direction);
Direction rightOf(Direction direction);
Direction opposite(Direction direction);
bool isEastWest(Direction direction);
/// A unit vector: north is -z, east is +x.
glm::vec3 vectorOf(Direction direction);
const char* nameOf(Direction direction);

struct MazeCell {
  int row = 0;
  int column = 0;

  MazeCell neighbor(Direction direction) const;
  auto operator<=>(const MazeCell&) const = default;
};

/// "(row 2, column 5)".
std::string nameOf(const MazeCell& cell);

/// What a cell is by its passages; the entrance is none.
enum class CellKind : uint8_t { kClosed, kDeadEnd, kStraight, kTurn, kThreeWay, kFourWay };

/// The gap in the outer wall.
struct MazeEntrance {
  MazeCell cell;
  Direction heading = Direction::kNorth;  ///< in which one walks in; the gap is on the opposite side of the cell

  bool operator==(const MazeEntrance&) const = default;
};

enum class LandmarkShape : uint8_t { kCone, kCube, kSphere, kColumn, kPyramid, kRing, kArch };
enum class LandmarkColor : uint8_t { kOrange, kSkyBlue, kGreen, kYellow, kBlue, kVermilion, kPurple, kIvory };

/// An object on the floor of a cell. An arch spans the passage; all others stand on a disc of radius kLandmarkRadius.
struct Landmark {
  MazeCell cell;
  LandmarkShape shape = LandmarkShape::kCone;
  LandmarkColor color = LandmarkColor::kOrange;
  float east = 0;  ///< from the middle of the cell, in cell sizes
  float south = 0;

  bool operator==(const Landmark&) const = default;
};
inline constexpr float kLandmarkRadius = 0.13f;  ///< in cell sizes

struct Maze {
  /// All walls stand.
  Maze(int rows, int columns);

  int rows() const { return rows_; }
  int columns() const { return columns_; }
  bool contains(const MazeCell& cell) const;
  size_t cellCount() const { return static_cast<size_t>(rows_) * static_cast<size_t>(columns_); }
  /// Row by row.
  size_t indexOf(const MazeCell& cell) const {
    return static_cast<size_t>(cell.row) * static_cast<size_t>(columns_) + static_cast<size_t>(cell.column);
  }

  /// Whether there is a passage to the neighbour; false at the border, whatever the entrance.
  bool isOpen(const MazeCell& cell, Direction direction) const;
  /// The neighbour must be in the maze.
  void setOpen(const MazeCell& cell, Direction direction, bool open);

  std::vector<Direction> passages(const MazeCell& cell) const;
  CellKind kind(const MazeCell& cell) const;

  /// The cell below or above which the point is, walls included; nothing beyond the middle line of the outer walls.
  std::optional<MazeCell> cellAt(const glm::vec3& point) const;
  /// Whether a point of any height stands in the plan of a wall or post; the faces count, and so does what lies beyond
  /// the middle line of the outer walls within their thickness.
  bool isInWall(const glm::vec3& point) const;

  /// On the floor.
  glm::vec3 centerOf(const MazeCell& cell) const;
  /// The whole cell, to the middle lines of its walls, from the floor to the top of the walls.
  Box cellBox(const MazeCell& cell) const;
  /// The cell between the faces of its walls: the box of a crossing. Passages of the same cross section join such
  /// boxes.
  Box clearBox(const MazeCell& cell) const;
  /// The rectangle of the passage or of the entrance on that side of the clear box, seen from within the cell.
  Portal openingOf(const MazeCell& cell, Direction direction) const;

  /// The cells that one walks over from `cell` in a straight line, to the first that is not straight: a turn, a
  /// crossing or a dead end. Empty where there is a wall.
  std::vector<MazeCell> ahead(const MazeCell& cell, Direction direction) const;

  std::optional<MazeEntrance> entrance;
  std::vector<Landmark> landmarks;
  float cellSize = 3.0f;
  float wallHeight = 2.4f;
  float wallThickness = 0.3f;
  glm::vec3 origin{0};

  bool operator==(const Maze&) const = default;

 private:
  size_t wallIndex(const MazeCell& cell, Direction direction) const;

  int rows_;
  int columns_;
  std::vector<uint8_t> open_;  ///< passages: those to the east of each cell, then those to its south
};

/// The same maze where the transform of its scene puts it: a uniform scale and a translation.
Maze moved(const Maze& maze, const glm::mat4& newFromOld);

}  // namespace ocelli
