// A grid maze in space: a plan of square cells with walls between some of them, one entrance, and landmarks.
//
// Row 0 lies in the north, column 0 in the west; x runs to the east, z to the south, y up. The floor is at
// the height of `origin`, which is the outer corner of the north-west: the middle line of the outer walls. Walls stand
// on the lines between cells, half of their thickness on either side, and a post of the same thickness stands at every
// corner of the grid. So every passage is as wide as a cell less one wall.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "oc_core/maze/maze_drawing.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/scene/portal.h"

namespace ocelli {

/// A unit vector: north is -z, east is +x.
glm::vec3 vectorOf(Direction direction);

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

struct Maze : MazePlan {
  /// All walls stand. Each side is 1 to kMaxMazeSide.
  Maze(int rows, int columns) : MazePlan(rows, columns) {}
  /// The passages of the plan.
  explicit Maze(MazePlan plan) : MazePlan(std::move(plan)) {}

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

  std::optional<MazeEntrance> entrance;
  std::vector<Landmark> landmarks;
  float cellSize = 3.0f;
  float wallHeight = 2.4f;
  float wallThickness = 0.3f;
  glm::vec3 origin{0};

  bool operator==(const Maze&) const = default;
};

/// The same maze where the transform of its scene puts it: a uniform scale and a translation.
Maze moved(const Maze& maze, const glm::mat4& newFromOld);

}  // namespace ocelli
