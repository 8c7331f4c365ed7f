#include "oc_core/constructor/walk_leaf.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ocelli {
namespace {

/// Of the height of a region: openings that are lower have a lintel.
constexpr double kLintel = 0.9;
/// Of the width of a door: few of the rays that part there meet what is left of the leaf, and more of them have room to
/// turn than at its end. Of 62 cells of three houses (seeds 1, 3 and 7) 54 are seen with 0.7, 45 with 1 or 1.2.
constexpr double kLeaf = 0.7;
/// Of the depth of a region: rays part at this depth at the latest.
constexpr double kDeepest = 0.4;

}  // namespace

bool isDoor(const WalkRegion& region, const WalkMouth& mouth) {
  return mouth.height() < kLintel * region.height;
}

WalkMouth beyondLeaf(const GraphCamera& camera, const WalkRegion& region, const PieceRays& rays,
                     const WalkMouth& whole) {
  const WalkMouth& door = rays.mouth;  // as much of it as they see
  if (!isDoor(region, whole)) {
    return door;
  }
  const glm::dvec2 ahead = door.ahead();
  const auto span = planSpan(region.border, door.middle(), door.middle() + ahead, 0);
  const double leaf = span ? std::min(kLeaf * whole.width(), kDeepest * span->second) : 0;
  const glm::dvec3 viewpoint = camera.frusta()[static_cast<size_t>(rays.frustum)].viewpoint;
  const double before = glm::dot(door.middle() - planOf(viewpoint), ahead);
  if (!(leaf > 0) || !(before > 0)) {
    return door;
  }
  const double grows = (before + leaf) / before;
  WalkMouth beyond = door;
  beyond.left = planOf(viewpoint) + (door.left - planOf(viewpoint)) * grows;
  beyond.right = planOf(viewpoint) + (door.right - planOf(viewpoint)) * grows;
  beyond.floor = region.floorAt(beyond.middle());
  beyond.top = std::min(viewpoint.y + (door.top - viewpoint.y) * grows, door.top);
  return beyond.height() > 0 ? beyond : door;
}

}  // namespace ocelli
