#include "oc_core/constructor/walk_ways.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/constructor/frustum_image.h"
#include "oc_core/constructor/image_parts.h"
#include "oc_core/constructor/walk_fans.h"

namespace ocelli {
namespace {

/// Of the rays, the share of the walls between the ways, where these take all of what bounds the crossing.
constexpr double kWallShare = 0.5;
/// Cosine of the angle between the way in and a way ahead.
constexpr double kAheadCosine = 0.7;
/// Openings nearer to the plane of the one that one comes in by than this, in its widths, lie beside it.
constexpr double kBesideOpening = 0.05;
/// Openings are not bent when nearly edge on: from the first of these angles to the second they bend less.
constexpr double kEdgeFrom = 70;
constexpr double kEdgeDegrees = 85;
/// A share of the way by which rays turn, of which less shows nothing else than straight ones.
constexpr double kMinBent = 1e-6;
/// Openings that are lower than this, in heights of the region, have a wall above them.
constexpr double kFullHeight = 0.95;
/// How far before the opening the viewpoint of the chosen way lies when it has all rays, in widths.
constexpr double kParallelWidths = 50;
/// How far the sides of the chosen way swing open: farther than rays of any usual image run apart.
constexpr double kOpenDegrees = 88;
constexpr double kShrunk = 2;  ///< how fast limits move outwards, in sizes of the region

double halfTangent(double degrees) {
  return std::tan(radiansFromDegrees(degrees) / 2);
}

/// Whose rays beyond a plane run between those from `bent` and those from `straight`.
glm::dvec3 between(const Plane& plane, const glm::dvec3& bent, const glm::dvec3& straight, double share) {
  const double one = share / plane.height(bent);
  const double other = (1 - share) / plane.height(straight);
  return (bent * one + straight * other) / (one + other);
}

bool isUpright(const Plane& side) {
  return std::abs(side.normal.y) < 0.5;
}

/// The plane turned outwards about the line where it meets `hinge`: by `angle` it lets those through that lie within
/// that, the farther the more.
Plane swung(const Plane& side, const Plane& hinge, double angle) {
  const glm::dvec3 normal = side.normal * std::cos(angle) + hinge.normal * std::sin(angle);
  const double length = glm::length(normal);
  return {normal / length, (side.distance * std::cos(angle) + hinge.distance * std::sin(angle)) / length};
}

/// Sides of a way swing open, those beside it about the edges of its mouth and its end about one of these sides, so
/// that rays that go on through openings farther ahead come in one after the other.
std::vector<Plane> swungOpen(const std::vector<Plane>& sides, const WalkMouth& mouth, double open) {
  const glm::dvec3 ahead = spaceOf(mouth.ahead(), 0);
  const Plane back = Plane::through(spaceOf(mouth.middle(), mouth.floor), -ahead);
  const auto isEnd = [&](const Plane& side) { return std::abs(glm::dot(side.normal, ahead)) > 0.5; };
  const auto beside =
      std::find_if(sides.begin(), sides.end(), [&](const Plane& side) { return isUpright(side) && !isEnd(side); });
  const double angle = radiansFromDegrees(kOpenDegrees) * open;
  std::vector<Plane> limits;
  for (const Plane& side : sides) {
    if (!isUpright(side)) {
      limits.push_back(side);  // floor and ceiling
    } else if (open < 1 && !isEnd(side)) {
      limits.push_back(swung(side, back, angle));
    } else if (open < 1 && beside != sides.end()) {
      limits.push_back(swung(side, *beside, angle));
    }
  }
  return limits;
}

class Ways {
 public:
  Ways(GraphCamera& camera, const WalkSpace& space, const WaysView& view)
      : camera_(camera), space_(space), view_(view) {}

  /// The rays of frustum `i` that pass through an exit look along the way that begins there.
  void lookAlong(int i, const WalkExit& exit, const glm::dvec3& straight, double share, const GraphCamera::Part& part,
                 WalkWay& way) {
    const WalkRegion& next = space_.regions()[exit.region];
    const WalkMouth& mouth = exit.mouth;
    const Plane plane = planeOf(mouth, next.size);
    const glm::dvec2 from = mouth.middle() - mouth.ahead() * (mouth.width() / 2 / halfTangent(view_.fovWayDegrees));
    const glm::dvec3 bent = spaceOf(from, mouth.floor + view_.eyeHeight);
    if (part.empty()) {
      way.why = "it is out of sight, or too small in the image";
      return;
    }
    way.frustum = bend(i, {plane, between(plane, bent, straight, share)}, "way to " + nameOfCell(exit.cell), part);
    if (way.frustum < 0) {
      way.why = "rays do not get there in a straight line";
      return;
    }
    const std::vector<Plane> sides = closedSides(next, share);
    const bool isChosen = view_.chosenPortal == exit.portal;
    limit(way.frustum, isChosen && view_.chosenOpen > 0 ? swungOpen(sides, mouth, view_.chosenOpen) : sides);
  }

  static Plane planeOf(const WalkMouth& mouth, double size) {
    return Plane::through(spaceOf(mouth.middle() + mouth.ahead() * (kWalkBeyond * size), 0), spaceOf(mouth.ahead(), 0));
  }

  int bend(int i, const GraphCamera::Bend& turn, const std::string& name, const GraphCamera::Part& part) {
    return bendWhereOneCan(camera_, i, turn, name, part);
  }
  void limit(int i, const std::vector<Plane>& planes) {
    for (const Plane& plane : planes) {
      limitWhereOneCan(camera_, i, plane);
    }
  }

  GraphCamera& camera_;
  const WalkSpace& space_;
  const WaysView& view_;
};

/// Left, ahead or right.
size_t sideOf(const WalkMouth& exit, const glm::dvec2& ahead) {
  if (glm::dot(exit.ahead(), ahead) > kAheadCosine) {
    return 1;
  }
  return planCross(ahead, exit.ahead()) < 0 ? 0 : 2;
}

/// What each aim should have of the opening, and how far behind it the outer viewpoints should lie.
void shareOut(std::vector<FanAim>& aims, const std::vector<WalkWay>& ways, const std::vector<size_t>& wayOfExit,
              const WaysView& view, double width) {
  const std::array<double, 3>& split = view.split;
  std::array<size_t, 3> counts{};
  double walls = 0;
  double all = 0;
  for (const FanAim& aim : aims) {
    const double length = glm::distance(aim.begin, aim.end);
    all += length;
    if (aim.exit < 0) {
      walls += length;
    } else {
      ++counts[ways[wayOfExit[static_cast<size_t>(aim.exit)]].side];
    }
  }
  double sum = 0;
  for (size_t side = 0; side < 3; ++side) {
    sum += counts[side] > 0 ? split[side] : 0;
  }
  const double toWalls = aims.size() == 1 ? 1 : kWallShare * walls / all;
  for (FanAim& aim : aims) {
    if (aim.exit < 0) {
      aim.share = toWalls * glm::distance(aim.begin, aim.end) / walls;
    } else {
      const size_t side = ways[wayOfExit[static_cast<size_t>(aim.exit)]].side;
      const double present = static_cast<double>(counts[0] + counts[1] + counts[2]);
      // What is asked for may not be there: then ways are alike.
      const double share = sum > 0 ? split[side] / sum / static_cast<double>(counts[side]) : 1 / present;
      aim.share = (1 - toWalls) * share;
    }
    aim.distance = std::max(width, 2 * std::max(aim.begin.y, aim.end.y));
    const bool chosen = aim.exit >= 0 && ways[wayOfExit[static_cast<size_t>(aim.exit)]].portal == view.chosenPortal;
    const double toChosen = view.chosenPortal ? view.chosenShare : 0;
    aim.share = glm::mix(aim.share, chosen ? 1.0 : 0.0, toChosen);
    // By how much its rays spread, so that they turn evenly while the viewpoint moves far away.
    aim.distance = 1 / glm::mix(1 / aim.distance, 1 / (kParallelWidths * width), chosen ? toChosen : 0);
  }
}

/// A limit, the farther outwards the less is deployed.
Plane movedOutwards(Plane plane, const WalkRegion& region, double deployed) {
  plane.distance += kShrunk * region.size * (1 / std::max(deployed, kMinBent) - 1);
  return plane;
}

/// Whether the exit leads out through that side.
bool isOnSide(const WalkExit& exit, const Plane& side) {
  return glm::dot(spaceOf(exit.mouth.ahead(), 0), side.normal) > 0.5;
}

std::array<glm::dvec3, 4> rectangle(const glm::dvec2& left, const glm::dvec2& right, double floor, double top) {
  return {spaceOf(left, floor), spaceOf(right, floor), spaceOf(right, top), spaceOf(left, top)};
}

}  // namespace

std::vector<Plane> allSides(const WalkRegion& region, double deployed) {
  std::vector<Plane> planes;
  for (const Plane& plane : region.limits) {
    planes.push_back(movedOutwards(plane, region, deployed));
  }
  return planes;
}

std::vector<Plane> closedSides(const WalkRegion& region, double deployed) {
  std::vector<Plane> planes;
  for (const Plane& plane : allSides(region, deployed)) {
    const bool closed = std::none_of(region.exits.begin(), region.exits.end(),
                                     [&](const WalkExit& exit) { return isOnSide(exit, plane); });
    if (closed) {
      planes.push_back(plane);
    }
  }
  return planes;
}

std::vector<WalkWay> addCrossingWays(GraphCamera& camera, const WalkSpace& space, const WalkExit& opening,
                                     const WaysView& view) {
  const WalkRegion& crossing = space.regions()[opening.region];
  const WalkMouth& entry = opening.mouth;
  const EntryFrame frame(entry);
  const double width = entry.width();
  std::vector<WalkWay> ways;
  std::vector<WalkExit> exits;
  std::vector<WalkMouth> mouths;
  std::vector<size_t> wayOfExit;
  for (const WalkExit& exit : crossing.exits) {
    if (exit.portal == opening.portal || exit.portal == WalkExit::kWithin) {
      continue;
    }
    WalkWay way{exit.portal, exit.cell, sideOf(exit.mouth, frame.ahead), -1, {}};
    if (frame.inFrame(exit.mouth.middle()).y > kBesideOpening * width) {
      wayOfExit.push_back(ways.size());
      exits.push_back(exit);
      mouths.push_back(exit.mouth);
    } else {
      way.why = "it begins beside the opening that one comes in by";
    }
    ways.push_back(way);
  }
  std::vector<FanAim> aims = aimsOf(frame, width, mouths);
  shareOut(aims, ways, wayOfExit, view, width);
  const glm::dvec3 eye(camera.root().eye());
  const glm::dvec2 rootAt = frame.inFrame(planOf(eye));
  const std::vector<FanRay> rays = mixedRays(straightRays(aims, width, rootAt), spreadRays(aims, width), view.deployed);
  Ways builder(camera, space, view);
  const Plane plane = Ways::planeOf(entry, crossing.size);
  const double beyond = kWalkBeyond * crossing.size;
  std::vector<size_t> order;
  for (size_t k = 0; k < aims.size(); ++k) {
    const auto at = [&](const FanRay& ray) { return frame.inPlan({ray.at + ray.slope * beyond, beyond}); };
    const std::optional<glm::dvec2> from = fanViewpoint(rays[k], rays[k + 1], width);
    const size_t way = aims[k].exit >= 0 ? wayOfExit[static_cast<size_t>(aims[k].exit)] : ways.size();
    if (way < ways.size()) {
      order.push_back(way);
      ways[way].why = "it is out of sight, or too small in the image";
    }
    if (!from) {
      continue;
    }
    const double ahead = std::max((aims[k].begin.y + aims[k].end.y) / 2, 1e-3 * width);
    const double floorAhead = aims[k].exit >= 0 ? exits[static_cast<size_t>(aims[k].exit)].mouth.floor : entry.floor;
    const double level = entry.floor + view.eyeHeight - (floorAhead - entry.floor) * -from->y / ahead;
    const glm::dvec3 viewpoint = spaceOf(frame.inPlan(*from), glm::mix(eye.y, level, view.deployed));
    const GraphCamera::Part part =
        imagePart(rectangle(at(rays[k]), at(rays[k + 1]), entry.floor, std::max(entry.top, view.eye.y)), camera.root());
    if (part.empty()) {
      continue;
    }
    const int fan = builder.bend(GraphCamera::kRoot, {plane, viewpoint}, nameOfCell(crossing.cell), part);
    if (fan < 0) {
      continue;
    }
    builder.limit(fan, allSides(crossing, view.deployed));
    if (way < ways.size()) {
      const WalkExit& exit = exits[static_cast<size_t>(aims[k].exit)];
      const double shift = kWalkBeyond * space.regions()[exit.region].size;
      const glm::dvec2 out = exit.mouth.ahead() * shift;
      const GraphCamera::Part through = frustumImage(
          camera, fan, rectangle(exit.mouth.left + out, exit.mouth.right + out, exit.mouth.floor, exit.mouth.top));
      ways[way].why.clear();
      builder.lookAlong(fan, exit, viewpoint, view.deployed, through, ways[way]);
    }
  }
  // Over an opening with a wall above it, rays of the root end there.
  if (entry.height() < kFullHeight * crossing.height) {
    builder.limit(GraphCamera::kRoot, {movedOutwards(plane, crossing, view.deployed)});
  }
  // From left to right; those that begin beside the opening come last.
  std::vector<WalkWay> sorted;
  for (const size_t way : order) {
    sorted.push_back(ways[way]);
  }
  for (size_t way = 0; way < ways.size(); ++way) {
    if (std::find(order.begin(), order.end(), way) == order.end()) {
      sorted.push_back(ways[way]);
    }
  }
  return sorted;
}

std::vector<WalkWay> addRoomWays(GraphCamera& camera, const WalkSpace& space, uint32_t number, const WaysView& view) {
  const WalkRegion& region = space.regions()[number];
  const glm::dvec2 eye = planOf(view.eye);
  const glm::dvec2 forward = glm::normalize(planOf(glm::dvec3(camera.root().forward())));
  Ways builder(camera, space, view);
  struct Seen {
    WalkWay way;
    double angle;
  };
  std::vector<Seen> seen;
  std::vector<std::pair<const WalkExit*, double>> inSight;  // by how much rays turn there
  for (const WalkExit& exit : region.exits) {
    if (exit.portal == WalkExit::kWithin) {
      continue;
    }
    const WalkMouth& mouth = exit.mouth;
    const glm::dvec2 to = mouth.middle() - eye;
    Seen each{{exit.portal, exit.cell, sideOf(mouth, forward), -1, {}},
              std::atan2(planCross(forward, to), glm::dot(forward, to))};
    const double before = glm::dot(to, mouth.ahead());
    const double aside = glm::dot(to, mouth.across());
    const double degrees = degreesFromRadians(std::atan2(std::abs(aside), std::max(before, 0.0)));
    const double share = view.deployed * (1 - glm::smoothstep(kEdgeFrom, kEdgeDegrees, degrees));
    const GraphCamera::Part part = imagePart(rectangle(mouth.left, mouth.right, mouth.floor, mouth.top), camera.root());
    if (!part.empty() && before > 0) {
      inSight.push_back({&exit, share});
    }
    if (!(before > 0) || !(share > kMinBent)) {
      each.way.why = "it is nearly edge on, or behind its opening";
      seen.push_back(each);
      continue;
    }
    // The eye, turned about the vertical through the middle of the opening until it faces it.
    const double distance = std::hypot(before, aside);
    const double angle = std::atan2(-aside, before) * (1 - share);
    const glm::dvec2 turned =
        mouth.middle() - mouth.ahead() * (distance * std::cos(angle)) + mouth.across() * (distance * std::sin(angle));
    const WalkRegion& next = space.regions()[exit.region];
    const Plane plane = Ways::planeOf(mouth, next.size);
    if (part.empty()) {
      each.way.why = "it is out of sight, or too small in the image";
    } else {
      each.way.frustum = builder.bend(GraphCamera::kRoot, {plane, spaceOf(turned, view.eye.y)},
                                      "way to " + nameOfCell(exit.cell), part);
      if (each.way.frustum < 0) {
        each.way.why = "its opening is too near";
      } else {
        builder.limit(each.way.frustum, closedSides(next, share));
      }
    }
    seen.push_back(each);
  }
  // Rays of the root end at the walls, as far as those through openings in them turn.
  for (const Plane& side : region.limits) {
    double share = view.deployed;
    for (const auto& [exit, turned] : inSight) {
      share = isOnSide(*exit, side) ? std::min(share, turned) : share;
    }
    if (share > kMinBent) {
      builder.limit(GraphCamera::kRoot, {movedOutwards(side, region, share)});
    }
  }
  std::stable_sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) { return a.angle < b.angle; });
  std::vector<WalkWay> ways;
  for (const Seen& each : seen) {
    ways.push_back(each.way);
  }
  return ways;
}

}  // namespace ocelli
