#include "oc_core/constructor/walk_region.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

namespace ocelli {
namespace {

/// Of lengths of a region: corners nearer to a border than this lie on it.
constexpr double kOnBorder = 1e-5;
/// Of the width of an opening that must lie on the border.
constexpr double kMinOnBorder = 0.5;
/// Of the area of a box: parts of it that are smaller, and no opening needs, are left out.
constexpr double kMinPart = 0.05;
constexpr size_t kMaxBoxParts = 8;  // of a box
/// Of the width of an opening: walls that are thinner have no region of their own.
constexpr double kThinWall = 0.5;
/// Of the width of an opening: what leads to it must be at least as wide.
constexpr double kMinLink = 0.3;
/// Cosine between a side of a box and an opening that leads out there.
constexpr double kOpenSide = 0.7;
/// How far beyond a box's side without openings rays find its wall, in sizes of the region: boxes may end before it.
constexpr double kBoxReach = 1;

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
  return {index, portal.to, portal.to, mouth, mouth};
}

/// A convex part of a box.
struct BoxPart {
  PlanPolygon border;
  std::vector<WalkExit> within;  ///< openings to other parts of the same box, by their numbers
};

/// Parts the box where openings lie within it: `parts[k]` has the opening on its border then, and what lies beside it
/// beyond its line is a new part.
void partAt(std::vector<BoxPart>& parts, size_t k, const WalkMouth& mouth, double boxArea,
            const std::vector<WalkExit>& exits) {
  const PlanPolygon whole = parts[k].border;
  const PlanPolygon inside = planRightOf(whole, mouth.left, mouth.right);
  const PlanPolygon beyond = planRightOf(whole, mouth.right, mouth.left);
  if (inside.empty() || beyond.empty()) {
    return;
  }
  const auto span = planSpan(whole, mouth.left, mouth.right, 0);
  if (!span) {
    return;
  }
  // Beside the opening, where more is left of the line.
  const bool left = -span->first > span->second - 1;
  const double from = left ? span->first : std::max(1.0, span->first);
  const double to = left ? std::min(0.0, span->second) : span->second;
  const glm::dvec2 across = mouth.right - mouth.left;
  const glm::dvec2 ahead = mouth.ahead();
  const PlanPolygon beside = left ? planRightOf(beyond, mouth.left + ahead, mouth.left)
                                  : planRightOf(beyond, mouth.right, mouth.right + ahead);
  const bool needed = std::any_of(exits.begin(), exits.end(), [&](const WalkExit& exit) {
    return planOutside(inside, exit.mouth.middle()) > 0 && planOutside(beside, exit.mouth.middle()) <= 0;
  });
  parts[k].border = inside;
  if (beside.empty() || (!needed && planArea(beside) < kMinPart * boxArea) || !(to > from)) {
    return;
  }
  WalkExit link;
  link.portal = WalkExit::kWithin;
  link.mouth = {mouth.left + across * from, mouth.left + across * to, mouth.floor, mouth.top};
  link.region = static_cast<uint32_t>(parts.size());
  parts[k].within.push_back(link);
  WalkExit back = link;
  back.mouth = link.mouth.reversed();
  back.region = static_cast<uint32_t>(k);
  parts.push_back({beside, {back}});
}

/// How far one goes back from a mouth, against its direction, until one is in the box; nothing where one never is.
std::optional<double> wayBack(const PlanPolygon& box, const WalkMouth& mouth) {
  const auto span = planSpan(box, mouth.middle(), mouth.middle() - mouth.ahead(), 0);
  return span && span->second > 0 ? std::optional(std::max(span->first, 0.0)) : std::nullopt;
}

/// Adds a part that leads from an opening outside of the box back to it; `depth` is how deep it is.
void addPassage(std::vector<BoxPart>& parts, const WalkMouth& mouth, double depth, double rounding) {
  const glm::dvec2 back = mouth.ahead() * -depth;
  PlanPolygon passage = planHull({mouth.left, mouth.right, mouth.left + back, mouth.right + back});
  const PlanPolygon box = parts[0].border;
  // What of it lies outside of one side of the box, most of it, and touches that.
  PlanPolygon best;
  WalkExit link;
  link.portal = WalkExit::kWithin;
  for (size_t i = 0; i < box.size(); ++i) {
    const glm::dvec2& a = box[i];
    const glm::dvec2& b = box[(i + 1) % box.size()];
    const PlanPolygon outside = planRightOf(passage, b, a);
    const auto edge = outside.empty() ? std::nullopt : planSpan(outside, a, b, rounding);
    if (!edge || planArea(outside) <= planArea(best)) {
      continue;
    }
    const double from = std::max(edge->first, 0.0);
    const double to = std::min(edge->second, 1.0);
    if ((to - from) * glm::distance(a, b) > kMinLink * mouth.width()) {
      best = outside;
      link.mouth = {a + (b - a) * from, a + (b - a) * to, mouth.floor, mouth.top};
    }
  }
  if (best.empty()) {
    return;
  }
  link.region = static_cast<uint32_t>(parts.size());
  parts[0].within.push_back(link);
  link.mouth = link.mouth.reversed();
  link.region = 0;
  parts.push_back({best, {link}});
}

/// The parts of a box; one, as a rule. The first holds the centre. Exits through thin walls begin at its sides.
std::vector<BoxPart> partsOf(const WalkCell& cell, std::vector<WalkExit>& exits) {
  const PlanPolygon box = planBox(cell);
  const double rounding = kOnBorder * shorterSide(cell);
  const glm::dvec2 center = planOf(glm::dvec3(cell.center));
  std::vector<BoxPart> parts{{box, {}}};
  for (WalkExit& exit : exits) {
    WalkMouth& mouth = exit.mouth;
    if (!(mouth.width() > 0) || !(planOutside(box, mouth.middle()) > rounding)) {
      continue;
    }
    const std::optional<double> back = wayBack(box, mouth);
    if (back && *back <= kThinWall * mouth.width()) {
      mouth.left -= mouth.ahead() * *back;
      mouth.right = mouth.left + exit.door.right - exit.door.left;
    } else if (parts.size() < kMaxBoxParts) {
      addPassage(parts, mouth, back ? *back + rounding : mouth.width(), rounding);
    }
  }
  for (const WalkExit& exit : exits) {
    for (size_t k = 0; exit.mouth.width() > 0 && k < parts.size() && parts.size() < kMaxBoxParts; ++k) {
      if (planOutside(parts[k].border, exit.mouth.middle()) < -rounding) {
        partAt(parts, k, exit.mouth, planArea(box), exits);
        break;
      }
    }
  }
  // The part around the centre comes first.
  for (size_t k = 1; k < parts.size(); ++k) {
    if (planOutside(parts[0].border, center) > 0 && planOutside(parts[k].border, center) <= 0) {
      std::swap(parts[0], parts[k]);
      for (BoxPart& part : parts) {
        for (WalkExit& link : part.within) {
          link.region = link.region == 0 ? static_cast<uint32_t>(k) : link.region == k ? 0 : link.region;
        }
      }
    }
  }
  return parts;
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
  std::vector<glm::dvec2> ground = region.border;
  for (const WalkExit& exit : kept) {
    ground.insert(ground.end(), {exit.door.left, exit.door.right});
  }
  region.ground = planHull(ground);
}

/// Sides, floor and ceiling. Walls may lie beyond the sides by `toWalls`.
void limitRegion(WalkRegion& region, double toWalls) {
  region.limits.clear();
  const double into = std::max(kWalkIntoWalls * region.size, toWalls);
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

WalkRegion regionOf(const WalkMap& map, uint32_t index) {
  const WalkCell& cell = map.cells[index];
  WalkRegion region;
  region.cell = index;
  region.height = static_cast<double>(cell.height);
  region.size = std::min(shorterSide(cell), region.height);
  region.floor = static_cast<double>(cell.center.y);
  region.floorPoint = planOf(glm::dvec3(cell.center));
  const double length = 2 * static_cast<double>(cell.halfLength);
  region.slope = planOf(glm::dvec3(cell.axis)) * (static_cast<double>(cell.floorRise) / length);
  return region;
}

/// Of a cell with these exits, each with the floor and height of the region.
std::vector<WalkRegion> regionsOf(const WalkMap& map, uint32_t index, std::vector<WalkExit> exits) {
  WalkRegion region = regionOf(map, index);
  if (!(region.size > 0)) {
    return {region};
  }
  for (WalkExit& exit : exits) {
    exit.door = exit.mouth;
  }
  std::vector<WalkRegion> regions;
  for (BoxPart& part : partsOf(map.cells[index], exits)) {
    region.border = part.border;
    region.exits = exits;
    for (WalkExit& link : part.within) {
      link.cell = index;
      link.mouth.floor = region.floorAt(link.mouth.middle());
      link.mouth.top = link.mouth.floor + region.height;
      link.door = link.mouth;
      region.exits.push_back(link);
    }
    keepExitsOnBorder(region);
    limitRegion(region, static_cast<double>(map.toWalls));
    regions.push_back(region);
  }
  return regions;
}

/// Exits through portals lead to the region of the next cell on whose border the portal lies.
void connect(std::vector<WalkRegion>& regions) {
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> regionAt;  // by portal and cell
  for (uint32_t i = 0; i < regions.size(); ++i) {
    for (const WalkExit& exit : regions[i].exits) {
      if (exit.portal != WalkExit::kWithin) {
        regionAt.try_emplace({exit.portal, regions[i].cell}, i);
      }
    }
  }
  for (WalkRegion& region : regions) {
    for (WalkExit& exit : region.exits) {
      if (exit.portal != WalkExit::kWithin) {
        const auto found = regionAt.find({exit.portal, exit.cell});
        exit.region = found != regionAt.end() ? found->second : exit.cell;
      }
    }
  }
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
  std::vector<WalkRegion> regions(map.cells.size());
  for (uint32_t i = 0; i < map.cells.size(); ++i) {
    // Numbers of parts become those of regions.
    std::vector<WalkRegion> parts = regionsOf(map, i, exits[i]);
    const auto numberOf = [&](size_t part) { return part == 0 ? i : static_cast<uint32_t>(regions.size() + part - 1); };
    for (WalkRegion& part : parts) {
      for (WalkExit& exit : part.exits) {
        exit.region = exit.portal == WalkExit::kWithin ? numberOf(exit.region) : exit.region;
      }
    }
    regions[i] = parts[0];
    regions.insert(regions.end(), parts.begin() + 1, parts.end());
  }
  connect(regions);
  return regions;
}

std::vector<WalkRegion> walkBoxesOf(const WalkMap& map) {
  std::vector<WalkRegion> regions;
  for (uint32_t i = 0; i < map.cells.size(); ++i) {
    WalkRegion region = regionOf(map, i);
    if (region.size > 0) {
      region.border = planBox(map.cells[i]);
      region.ground = region.border;
    }
    regions.push_back(region);
  }
  for (uint32_t i = 0; i < map.portals.size(); ++i) {
    const WalkPortal& portal = map.portals[i];
    if (portal.from == portal.to || portal.from >= regions.size() || portal.to >= regions.size()) {
      continue;
    }
    for (const WalkPortal& seen : {portal, portal.reversed()}) {
      const WalkExit exit = exitOf(i, seen);
      if (exit.mouth.width() > 0 && exit.mouth.height() > 0) {
        regions[seen.from].exits.push_back(exit);
      }
    }
  }
  for (WalkRegion& region : regions) {
    for (size_t i = 0; i < region.border.size(); ++i) {
      const glm::dvec2& a = region.border[i];
      const glm::dvec2 along = glm::normalize(region.border[(i + 1) % region.border.size()] - a);
      const glm::dvec2 out(along.y, -along.x);
      const bool open = std::any_of(region.exits.begin(), region.exits.end(), [&](const WalkExit& exit) {
        return glm::dot(exit.mouth.ahead(), out) > kOpenSide;
      });
      if (!open) {
        region.limits.push_back(Plane::through(spaceOf(a + out * (kBoxReach * region.size), 0), spaceOf(out, 0)));
      }
    }
  }
  return regions;
}

}  // namespace ocelli
