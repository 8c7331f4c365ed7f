// The truth of where one can walk in `builtin:city`, from its plan.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/worlds/city_plan.h"
#include "oc_core/worlds/plan_walk.h"

namespace ocelli {
namespace {

constexpr float kShortSegment = 2;  // metres; a piece of street as short as that belongs to the crossing beside it
constexpr float kMinMouth = 0.9f;   // of openings between cells
constexpr float kStreetHeight = 6;  // of cells: lower than every house
constexpr float kMouthHeight = 16;  // of openings as one looks through them: that of the tallest houses
constexpr float kEdge = 1e-3f;
constexpr float kEyeOverFloor = 1.7f;

struct Interval {
  float from, to;
};

class CityWalks {
 public:
  explicit CityWalks(const CityPlan& plan) : plan_(plan) {}

  WalkMap map() {
    const glm::vec2 gate(plan_.gate.x, plan_.gate.z);
    addCell(WalkCellKind::kTunnel, {gate - glm::vec2(kCityGateHalfWidth, 0),
                                    gate + glm::vec2(kCityGateHalfWidth, kCityWallThickness + kCityForecourt)});
    // What is before the gate: its axis runs to the north, through the gate.
    WalkCell& forecourt = map_.cells.back();
    const float length = 2 * forecourt.halfLength;
    forecourt.height = kCityGateHeight;
    forecourt.rings = {{0, kCityGateHalfWidth, kCityGateHalfWidth, kCityGateHeight},
                       {length, kCityGateHalfWidth, kCityGateHalfWidth, kCityGateHeight}};
    for (const CityBlock& block : plan_.blocks) {
      if (block.isSquare) {
        squares_.push_back(block.withStreets());
        addCell(WalkCellKind::kRoom, squares_.back());
      }
    }
    for (const CityStreet& street : plan_.streets) {
      addStreet(street);
    }
    openTouchingCells(map_, kMinMouth);
    numberCells(map_);
    return std::move(map_);
  }

 private:
  void addCell(WalkCellKind kind, const CityRectangle& area) {
    map_.cells.push_back(levelCell(kind, area.lower, area.upper, 0, kStreetHeight));
  }

  static Interval along(const CityStreet& street, const CityRectangle& area) {
    return street.isAlongX ? Interval{area.lower.x, area.upper.x} : Interval{area.lower.y, area.upper.y};
  }
  static Interval across(const CityStreet& street, const CityRectangle& area) {
    return street.isAlongX ? Interval{area.lower.y, area.upper.y} : Interval{area.lower.x, area.upper.x};
  }
  static CityRectangle piece(const CityStreet& street, const Interval& along) {
    CityRectangle area = street.area;
    const glm::length_t axis = street.isAlongX ? 0 : 1;
    area.lower[axis] = along.from;
    area.upper[axis] = along.to;
    return area;
  }

  /// Takes `taken` out of pieces that are in order.
  static std::vector<Interval> without(const std::vector<Interval>& pieces, const Interval& taken) {
    std::vector<Interval> left;
    for (const Interval& piece : pieces) {
      if (taken.to <= piece.from || piece.to <= taken.from) {
        left.push_back(piece);
        continue;
      }
      if (piece.from < taken.from) {
        left.push_back({piece.from, taken.from});
      }
      if (taken.to < piece.to) {
        left.push_back({taken.to, piece.to});
      }
    }
    return left;
  }

  /// Squares take their part of it; where other streets end at the rest are crossings, and between those are tunnels.
  void addStreet(const CityStreet& street) {
    std::vector<Interval> free{along(street, street.area)};
    for (const CityRectangle& square : squares_) {
      if (square.meets(street.area)) {
        free = without(free, along(street, square));
      }
    }
    for (const Interval& part : free) {
      if (part.to - part.from > kEdge) {
        addPart(street, part);
      }
    }
  }

  void addPart(const CityStreet& street, const Interval& part) {
    std::vector<Interval> crossings;
    for (const CityStreet& other : plan_.streets) {
      if (other.isAlongX == street.isAlongX || other.area.meets(street.area)) {
        continue;
      }
      const Interval reach = across(street, other.area);
      const Interval width = across(street, street.area);
      const bool ends = std::abs(reach.to - width.from) < kEdge || std::abs(reach.from - width.to) < kEdge;
      Interval mouth = along(street, other.area);
      mouth = {std::max(mouth.from, part.from), std::min(mouth.to, part.to)};
      if (ends && mouth.to - mouth.from > kMinMouth) {
        crossings.push_back(mouth);
      }
    }
    std::sort(crossings.begin(), crossings.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
    // Crossings that are nearly one, and what is left over before and behind them.
    std::vector<Interval> merged;
    for (const Interval& crossing : crossings) {
      if (!merged.empty() && crossing.from - merged.back().to < kShortSegment) {
        merged.back().to = std::max(merged.back().to, crossing.to);
      } else {
        merged.push_back(crossing);
      }
    }
    if (!merged.empty()) {
      merged.front().from = merged.front().from - part.from < kShortSegment ? part.from : merged.front().from;
      merged.back().to = part.to - merged.back().to < kShortSegment ? part.to : merged.back().to;
    }
    float from = part.from;
    for (const Interval& crossing : merged) {
      addTunnel(street, {from, crossing.from});
      addCell(WalkCellKind::kRoom, piece(street, crossing));
      from = crossing.to;
    }
    addTunnel(street, {from, part.to});
  }

  void addTunnel(const CityStreet& street, const Interval& part) {
    if (part.to - part.from < kEdge) {
      return;
    }
    addCell(WalkCellKind::kTunnel, piece(street, part));
    WalkCell& cell = map_.cells.back();
    // levelCell() chose the axis by the sides; that of a tunnel is its street's.
    if ((std::abs(cell.axis.x) > 0.5f) != street.isAlongX) {
      cell.axis = street.isAlongX ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, -1);
      std::swap(cell.halfLength, cell.halfWidth);
    }
    addRings(street, part, cell);
  }

  /// Two rings for each piece of it along which neither facade changes.
  void addRings(const CityStreet& street, const Interval& part, WalkCell& cell) const {
    std::vector<float> changes{part.from, part.to};
    std::vector<const CityHouse*> low;  // to the north of a street along x, to the west of one along z
    std::vector<const CityHouse*> high;
    const Interval edges = across(street, street.area);
    for (const CityHouse& house : plan_.houses) {
      const Interval span = along(street, house.area);
      const Interval reach = across(street, house.area);
      constexpr float kMaxGap = 2;  // more than facades stand back
      const bool isLow = reach.to <= edges.from + kEdge && reach.to > edges.from - kMaxGap;
      const bool isHigh = reach.from >= edges.to - kEdge && reach.from < edges.to + kMaxGap;
      if (span.to <= part.from || part.to <= span.from || !(isLow || isHigh)) {
        continue;
      }
      (isLow ? low : high).push_back(&house);
      for (const float change : {span.from, span.to}) {
        if (change > part.from && change < part.to) {
          changes.push_back(change);
        }
      }
    }
    std::sort(changes.begin(), changes.end());
    const float middle = (edges.from + edges.to) / 2;
    const auto distance = [&](const std::vector<const CityHouse*>& houses, float at, bool isLow) {
      for (const CityHouse* house : houses) {
        const Interval span = along(street, house->area);
        const Interval reach = across(street, house->area);
        if (span.from <= at && at <= span.to) {
          return isLow ? middle - reach.to : reach.from - middle;
        }
      }
      return (edges.to - edges.from) / 2;
    };
    // North is to the left of who walks to the east, and west to the left of who walks to the north, against z.
    std::vector<WalkRing> rings;
    for (size_t i = 0; i + 1 < changes.size(); ++i) {
      if (changes[i + 1] - changes[i] < kEdge) {
        continue;
      }
      const float at = (changes[i] + changes[i + 1]) / 2;
      const float left = distance(low, at, true);
      const float right = distance(high, at, false);
      for (const float end : {changes[i], changes[i + 1]}) {
        rings.push_back({street.isAlongX ? end - part.from : part.to - end, left, right, kStreetHeight});
      }
    }
    if (!street.isAlongX) {
      std::reverse(rings.begin(), rings.end());
    }
    cell.rings = std::move(rings);
  }

  const CityPlan& plan_;
  std::vector<CityRectangle> squares_;
  WalkMap map_;
};

}  // namespace

WalkMap cityWalkMap(const CityPlan& plan) {
  return CityWalks(plan).map();
}

std::vector<Portal> cityPortals(const CityPlan& plan) {
  std::vector<Portal> portals;
  for (const WalkPortal& portal : cityWalkMap(plan).portals) {
    for (Portal opening : {portal.opening, portal.reversed().opening}) {
      if (portal.from != 0 && portal.to != 0) {
        const glm::vec3 foot = opening.center - opening.halfUp;
        opening = uprightOpening(foot, opening.normal, glm::length(opening.halfRight), kMouthHeight);
      }
      portals.push_back(opening);
    }
  }
  return portals;
}

std::vector<glm::vec3> cityPath(const CityPlan& plan) {
  const WalkMap map = cityWalkMap(plan);
  // Squares come behind the cell before the gate; there is always one.
  return lineOfWay(map, wayThroughCells(map, 0, 1), kEyeOverFloor);
}

}  // namespace ocelli
