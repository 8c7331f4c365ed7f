#include "oc_core/constructor/walk_space.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace ocelli {
namespace {

/// Cosine of the angle by which a straight tunnel may turn in the next.
constexpr double kStraight = 0.98;
/// The same between the way and an opening at its end.
constexpr double kAtEnd = 0.7;
/// Walls are at least so far aside of an eye, in half widths of the cell, where rings have no width.
constexpr double kMinAside = 1e-3;

bool isTunnel(const WalkSpace& space, uint32_t region) {
  return space.map().cells[space.regions()[region].cell].kind == WalkCellKind::kTunnel;
}

glm::dvec2 axisOf(const WalkSpace& space, uint32_t region) {
  return planOf(glm::dvec3(space.map().cells[space.regions()[region].cell].axis));
}

/// The widest exit at the end of a tunnel; nothing at a dead end.
const WalkExit* exitAtEnd(const WalkRegion& region, const glm::dvec2& direction) {
  const WalkExit* widest = nullptr;
  for (const WalkExit& exit : region.exits) {
    if (glm::dot(exit.mouth.ahead(), direction) > kAtEnd &&
        (widest == nullptr || exit.mouth.width() > widest->mouth.width())) {
      widest = &exit;
    }
  }
  return widest;
}

/// The opening by which one comes out of straight tunnels that follow each other.
const WalkExit* lastOpening(const WalkSpace& space, uint32_t region, glm::dvec2 direction) {
  const WalkExit* opening = exitAtEnd(space.regions()[region], direction);
  for (size_t count = 0; opening != nullptr && count < space.regions().size(); ++count) {
    const uint32_t next = opening->region;
    const double along = glm::dot(axisOf(space, next), direction);
    if (!isTunnel(space, next) || std::abs(along) < kStraight) {
      return opening;
    }
    direction = axisOf(space, next) * (along > 0 ? 1.0 : -1.0);
    opening = exitAtEnd(space.regions()[next], direction);
  }
  return opening;
}

/// From the axis to the walls of a tunnel, seen along the axis: left and right.
std::pair<double, double> wallsAt(const WalkCell& cell, double along) {
  const auto half = static_cast<double>(cell.halfWidth);
  if (cell.rings.size() < 2) {
    return {half, half};
  }
  const auto after = std::find_if(cell.rings.begin() + 1, cell.rings.end() - 1,
                                  [&](const WalkRing& ring) { return static_cast<double>(ring.along) >= along; });
  const WalkRing& b = *after;
  const WalkRing& a = *(after - 1);
  const double length = static_cast<double>(b.along) - static_cast<double>(a.along);
  const double share = length > 0 ? std::clamp((along - static_cast<double>(a.along)) / length, 0.0, 1.0) : 0;
  return {glm::mix(static_cast<double>(a.left), static_cast<double>(b.left), share),
          glm::mix(static_cast<double>(a.right), static_cast<double>(b.right), share)};
}

}  // namespace

WalkSpace::WalkSpace(WalkMap map) : map_(std::move(map)), regions_(walkRegionsOf(map_)) {
  glm::dvec3 lower(std::numeric_limits<double>::infinity());
  glm::dvec3 upper(-lower);
  std::vector<double> sizes;
  for (const WalkRegion& region : regions_) {
    for (const glm::dvec2& corner : region.border) {
      lower = glm::min(lower, spaceOf(corner, region.floorAt(corner)));
      upper = glm::max(upper, spaceOf(corner, region.floorAt(corner) + region.height));
    }
    if (!region.border.empty()) {
      sizes.push_back(region.size);
    }
  }
  if (!sizes.empty()) {
    center_ = (lower + upper) / 2.0;
    reach_ = glm::distance(lower, upper) / 2;
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
    size_ = sizes[sizes.size() / 2];
  }
}

std::optional<uint32_t> WalkSpace::regionAt(const glm::dvec3& eye) const {
  std::optional<uint32_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (uint32_t i = 0; i < regions_.size(); ++i) {
    const WalkRegion& region = regions_[i];
    if (region.border.empty() || planOutside(region.ground, planOf(eye)) > 1e-6 * region.size) {
      continue;
    }
    const double above = eye.y - region.floorAt(planOf(eye));
    if (above >= 0 && above <= region.height && above < least) {
      least = above;
      best = i;
    }
  }
  return best;
}

std::optional<uint32_t> WalkSpace::cellAt(const glm::dvec3& eye) const {
  const std::optional<uint32_t> region = regionAt(eye);
  return region ? std::optional(regions_[*region].cell) : std::nullopt;
}

WalkAhead lookAhead(const WalkSpace& space, uint32_t region, const glm::dvec2& eye, const glm::dvec2& heading) {
  const WalkCell& tunnel = space.map().cells[space.regions()[region].cell];
  const glm::dvec2 axis = axisOf(space, region);
  const bool along = glm::dot(heading, axis) >= 0;
  WalkAhead ahead;
  ahead.direction = along ? axis : -axis;
  const glm::dvec2 offset = eye - planOf(glm::dvec3(tunnel.center));
  const glm::dvec2 right(-axis.y, axis.x);
  const double aside = glm::dot(offset, right);
  const auto [left, rightWall] = wallsAt(tunnel, glm::dot(offset, axis) + static_cast<double>(tunnel.halfLength));
  // The eye may stand in an opening beside it, beyond the wall.
  const double least = std::max(0.05 * (left + rightWall), kMinAside * static_cast<double>(tunnel.halfWidth));
  ahead.left = std::max(along ? left + aside : rightWall - aside, least);
  ahead.right = std::max(along ? rightWall - aside : left + aside, least);
  if (const WalkExit* opening = lastOpening(space, region, ahead.direction)) {
    ahead.opening = *opening;
    ahead.distance = std::max(0.0, glm::dot(opening->door.middle() - eye, opening->door.ahead()));
  }
  if (const WalkExit* opening = lastOpening(space, region, -ahead.direction)) {
    ahead.behind = std::max(0.0, glm::dot(opening->door.middle() - eye, opening->door.ahead()));
  }
  return ahead;
}

double distanceTo(const WalkMouth& mouth, const glm::dvec2& point) {
  const glm::dvec2 along = mouth.right - mouth.left;
  const double share = std::clamp(glm::dot(point - mouth.left, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::distance(point, mouth.left + along * share);
}

}  // namespace ocelli
