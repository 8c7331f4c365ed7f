// The cells of a walk map as rays of cameras see them: convex regions with a floor and a ceiling, and the openings on
// their borders.
//
// The region of a cell is its box. An opening in a wall beside it is an opening of the box's side as well; where it
// lies farther away, a second region leads there. So does one where an opening lies within the box, as where a corner
// of a room belongs to another cell.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/camera/plane.h"
#include "oc_core/constructor/plan_polygon.h"
#include "oc_core/scene/walk_map.h"

namespace ocelli {

inline glm::dvec2 planOf(const glm::dvec3& point) {
  return {point.x, point.z};
}
inline glm::dvec3 spaceOf(const glm::dvec2& point, double height) {
  return {point.x, height, point.y};
}

/// An opening as someone sees it who goes through it.
struct WalkMouth {
  glm::dvec2 left{0};
  glm::dvec2 right{0};
  double floor = 0;
  double top = 0;

  glm::dvec2 middle() const { return (left + right) / 2.0; }
  glm::dvec2 across() const { return glm::normalize(right - left); }
  glm::dvec2 ahead() const { return {across().y, -across().x}; }
  double width() const { return glm::distance(left, right); }
  double height() const { return top - floor; }
  /// For who comes the other way.
  WalkMouth reversed() const { return {right, left, floor, top}; }
};

/// A way out of a region.
struct WalkExit {
  static constexpr uint32_t kWithin = UINT32_MAX;  ///< instead of a portal: it leads on within the same cell

  uint32_t portal = 0;  ///< of WalkMap::portals
  uint32_t cell = 0;    ///< where it leads
  uint32_t region = 0;  ///< of that cell
  WalkMouth mouth;      ///< on the border of the region, seen by who leaves
  WalkMouth door{};     ///< the opening itself, which may lie beyond, in a wall
};

struct WalkRegion {
  uint32_t cell = 0;
  PlanPolygon border;
  PlanPolygon ground;           ///< with the floor in the openings
  std::vector<WalkExit> exits;  ///< those whose openings lie on the border
  /// Sides, floor and ceiling; normals point out of it, beyond the walls (WalkMap::toWalls), or by a hair.
  std::vector<Plane> limits;
  double size = 0;  ///< the shortest of width, length and height

  /// Of the floor of the cell's box, which may slope, below or above a point.
  double floorAt(const glm::dvec2& point) const { return floor + glm::dot(slope, point - floorPoint); }
  double floor = 0;
  glm::dvec2 floorPoint{0};
  glm::dvec2 slope{0};
  double height = 0;
};

/// How far rays go into walls and floor before they end, in sizes of the region: surfaces must not lie at their ends,
/// where rounding would decide.
inline constexpr double kWalkIntoWalls = 2e-4;
/// Where a way begins beyond the opening, in sizes of the region: the planes at which rays turn must not touch.
inline constexpr double kWalkBeyond = 1e-4;

/// First that of each cell around its centre, in the order of the cells, then second ones. Openings that have no area
/// are left out, and such to which no way leads within the cell.
std::vector<WalkRegion> walkRegionsOf(const WalkMap& map);

/// The box of each cell as one region, whatever others it reaches into, with all its openings where they are. Limits
/// are those of sides without openings, by the region's size beyond them, where their walls are found.
std::vector<WalkRegion> walkBoxesOf(const WalkMap& map);

}  // namespace ocelli
