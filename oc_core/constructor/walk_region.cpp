#include "oc_core/constructor/walk_region.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace ocelli {
namespace {

/// Of lengths of a region: corners nearer to a border than this lie on it.
constexpr double kOnBorder = 1e-5;
/// Of the width of an opening that must lie on the border.
constexpr double kMinOnBorder = 0.5;
/// Of the area of a box that an opening within it may cut off.
constexpr double kMaxCutOff = 0.25;
/// How far outside of a box an opening may lie, in shorter sides of the box: walls are not thicker.
constexpr double kMaxOutside = 0.5;

PlanPolygon planBox(const WalkCell& cell) {
  const glm::dvec2 center = planOf(glm::dvec3(cell.center));
  const glm::dvec2 along = planOf(glm::dvec3(cell.axis)) * static_cast<double>(cell.halfLength);
  const glm::dvec2 across = planOf(glm::dvec3(cell.right())) * static_cast<double>(cell.halfWidth);
  return planHull({center - along - across, center - along + across, center + along - across, center + along + across});
}

double shorterSide(const WalkCell& cell) {
  return 2 * static_cast<double>(std::min(cell.halfLength, cell.halfWidth));
}

WalkExit exitOf(uint32_t index, const WalkPortal& portal) {
  WalkMouth mouth;
  mouth.left = planOf(glm::dvec3(portal.opening.center - portal.opening.halfRight));
  mouth.right = planOf(glm::dvec3(portal.opening.center + portal.opening.halfRight));
  mouth.floor = std::numeric_limits<double>::infinity();
  mouth.top = -mouth.floor;
  for (const glm::vec3& corner : portal.opening.corners()) {
    mouth.floor = std::min(mouth.floor, static_cast<double>(corner.y));
    mouth.top = std::max(mouth.top, static_cast<double>(corner.y));
  }
  return {index, portal.to, mouth};
}

/// That one leaves the cell through it, whichever way its normal points.
void turnOutwards(WalkMouth& mouth, const glm::dvec2& center) {
  if (glm::dot(mouth.ahead(), center - mouth.middle()) > 0) {
    std::swap(mouth.left, mouth.right);
  }
}

/// The border of a box that reaches to the openings on its sides.
PlanPolygon borderAround(const WalkCell& cell, std::vector<WalkExit>& exits) {
  const PlanPolygon box = planBox(cell);
  PlanPolygon cut = box;
  std::vector<glm::dvec2> points;
  std::vector<WalkExit> kept;
  for (const WalkExit& exit : exits) {
    const WalkMouth& mouth = exit.mouth;
    if (planOutside(box, mouth.middle()) > 0) {
      if (planOutside(box, mouth.middle()) <= kMaxOutside * shorterSide(cell)) {
        points.insert(points.end(), {mouth.left, mouth.right});
        kept.push_back(exit);
      }
      continue;
    }
    const PlanPolygon rest = planRightOf(cut, mouth.left, mouth.right);
    if (planArea(rest) >= (1 - kMaxCutOff) * planArea(box)) {
      cut = rest;
      kept.push_back(exit);
    }
  }
  exits = kept;
  points.insert(points.end(), cut.begin(), cut.end());
  PlanPolygon border = planHull(points);
  for (const WalkExit& exit : exits) {
    const PlanPolygon rest = planRightOf(border, exit.mouth.left, exit.mouth.right);
    border = planArea(rest) >= (1 - kMaxCutOff) * planArea(border) ? rest : border;
  }
  return border;
}

void keepExitsOnBorder(WalkRegion& region) {
  const double rounding = kOnBorder * region.size;
  std::vector<WalkExit> kept;
  for (WalkExit exit : region.exits) {
    WalkMouth& mouth = exit.mouth;
    const auto span = planSpan(region.border, mouth.left, mouth.right, rounding);
    if (!span) {
      continue;
    }
    const double from = std::clamp(span->first, 0.0, 1.0);
    const double to = std::clamp(span->second, 0.0, 1.0);
    const glm::dvec2 left = mouth.left;
    const glm::dvec2 across = mouth.right - mouth.left;
    mouth.left = left + across * from;
    mouth.right = left + across * to;
    if (to - from >= kMinOnBorder && planOutside(region.border, mouth.middle()) >= -rounding) {
      kept.push_back(exit);
    }
  }
  region.exits = kept;
}

/// Sides, floor and ceiling.
void limitRegion(WalkRegion& region) {
  region.limits.clear();
  const double into = kWalkIntoWalls * region.size;
  for (size_t i = 0; i < region.border.size(); ++i) {
    const glm::dvec2& a = region.border[i];
    const glm::dvec2 along = glm::normalize(region.border[(i + 1) % region.border.size()] - a);
    const glm::dvec2 out(along.y, -along.x);
    region.limits.push_back(Plane::through(spaceOf(a + out * into, 0), spaceOf(out, 0)));
  }
  double below = 0;
  double above = 0;
  for (const WalkExit& exit : region.exits) {
    for (const glm::dvec2& side : {exit.mouth.left, exit.mouth.right}) {
      below = std::max(below, region.floorAt(side) - exit.mouth.floor);
      above = std::max(above, exit.mouth.top - region.floorAt(side) - region.height);
    }
  }
  const glm::dvec3 up(-region.slope.x, 1, -region.slope.y);
  region.limits.push_back(Plane::through(spaceOf(region.floorPoint, region.floor - below - into), -up));
  region.limits.push_back(Plane::through(spaceOf(region.floorPoint, region.floor + region.height + above + into), up));
}

WalkRegion regionOf(const WalkMap& map, uint32_t index, std::vector<WalkExit> exits) {
  const WalkCell& cell = map.cells[index];
  WalkRegion region;
  region.cell = index;
  region.height = static_cast<double>(cell.height);
  region.size = std::min(shorterSide(cell), region.height);
  region.floor = static_cast<double>(cell.center.y);
  region.floorPoint = planOf(glm::dvec3(cell.center));
  region.slope = planOf(glm::dvec3(cell.axis)) *
                 (static_cast<double>(cell.floorRise) / (2 * static_cast<double>(cell.halfLength)));
  if (!(region.size > 0)) {
    return region;
  }
  for (WalkExit& exit : exits) {
    turnOutwards(exit.mouth, region.floorPoint);
  }
  region.border = borderAround(cell, exits);
  region.exits = exits;
  keepExitsOnBorder(region);
  limitRegion(region);
  return region;
}

/// Whether floors and ceilings leave room for both in one point of the plan.
bool shareHeights(const WalkRegion& one, const WalkRegion& other) {
  const auto range = [](const WalkRegion& region) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const glm::dvec2& corner : region.border) {
      least = std::min(least, region.floorAt(corner));
      most = std::max(most, region.floorAt(corner));
    }
    return std::pair(least, most + region.height);
  };
  const auto [floor, top] = range(one);
  const auto [otherFloor, otherTop] = range(other);
  return std::min(top, otherTop) - std::max(floor, otherFloor) > 1e-3 * std::min(one.height, other.height);
}

}  // namespace

std::vector<WalkRegion> walkRegionsOf(const WalkMap& map) {
  std::vector<std::vector<WalkExit>> exits(map.cells.size());
  for (uint32_t i = 0; i < map.portals.size(); ++i) {
    const WalkPortal& portal = map.portals[i];
    if (portal.from == portal.to || portal.from >= exits.size() || portal.to >= exits.size()) {
      continue;
    }
    for (const WalkPortal& seen : {portal, portal.reversed()}) {
      const WalkExit exit = exitOf(i, seen);
      if (exit.mouth.width() > 0 && exit.mouth.height() > 0) {
        exits[seen.from].push_back(exit);
      }
    }
  }
  std::vector<WalkRegion> regions;
  for (uint32_t i = 0; i < map.cells.size(); ++i) {
    regions.push_back(regionOf(map, i, exits[i]));
  }
  return regions;
}

void cutToFit(WalkRegion& region, const WalkMap& map, const std::vector<const WalkRegion*>& others, double allowed) {
  const glm::dvec2 center = planOf(glm::dvec3(map.cells[region.cell].center));
  bool changed = false;
  for (const WalkRegion* other : others) {
    if (region.border.empty() || planPenetration(region.border, other->border) <= allowed ||
        !shareHeights(region, *other)) {
      continue;
    }
    PlanPolygon best;
    for (size_t i = 0; i < other->border.size(); ++i) {
      // Outside of that side.
      const PlanPolygon rest =
          planRightOf(region.border, other->border[(i + 1) % other->border.size()], other->border[i]);
      if (!rest.empty() && planOutside(rest, center) < 0 && planArea(rest) > planArea(best)) {
        best = rest;
      }
    }
    region.border = best;
    changed = true;
  }
  if (region.border.empty()) {
    region.exits.clear();
  } else if (changed) {
    keepExitsOnBorder(region);
    limitRegion(region);
  }
}

}  // namespace ocelli
