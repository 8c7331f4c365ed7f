// The cells of a walk map as rays of cameras see them: convex regions with a floor and a ceiling, and the openings on
// their borders. Regions are disjoint: where boxes of a map reach into each other, the later ones are cut.
//
// A region is the box of its cell, and reaches to the openings on its sides, which may lie within the wall that parts
// it from the next cell.
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

/// A way out of a cell.
struct WalkExit {
  uint32_t portal = 0;  ///< of WalkMap::portals
  uint32_t cell = 0;    ///< where it leads
  WalkMouth mouth;      ///< seen by who leaves
};

struct WalkRegion {
  uint32_t cell = 0;
  PlanPolygon border;
  std::vector<WalkExit> exits;  ///< those whose openings lie on the border
  std::vector<Plane> limits;    ///< sides, floor and ceiling; normals point out of it, by a hair beyond the surfaces
  double size = 0;              ///< the shortest of width, length and height

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

/// Of each cell, all of its openings, and both sides of those that lead from a cell into the same one left out.
/// Openings that have no area are as well, and such that do not lie on the border: farther within it than the fourth
/// part of its area, or farther outside than half of its shorter side.
std::vector<WalkRegion> walkRegionsOf(const WalkMap& map);

/// Cuts the region where it reaches into one of `others` by more than `allowed`, at the side of that which leaves most
/// of it with its centre. Its border is empty where nothing is left. Exits that no longer lie on the border are gone.
void cutToFit(WalkRegion& region, const WalkMap& map, const std::vector<const WalkRegion*>& others, double allowed);

}  // namespace ocelli
