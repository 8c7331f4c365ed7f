// Where someone stands in a walk map, and what lies ahead along the tunnel that he walks in.
#pragma once

#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/constructor/walk_region.h"

namespace ocelli {

/// A walk map prepared for cameras that are built for every frame.
class WalkSpace {
 public:
  explicit WalkSpace(WalkMap map);

  const WalkMap& map() const { return map_; }
  const std::vector<WalkRegion>& regions() const { return regions_; }
  /// Half of the diagonal of all regions, or 1 where there are none.
  double reach() const { return reach_; }
  /// From there nothing of the map is farther.
  double reachFrom(const glm::dvec3& eye) const { return glm::distance(eye, center_) + reach_; }
  /// Of a region as a rule: the median.
  double size() const { return size_; }

  /// The region whose floor is below the eye, with its ceiling above; of several the one whose floor is nearest.
  std::optional<uint32_t> regionAt(const glm::dvec3& eye) const;
  /// Its cell.
  std::optional<uint32_t> cellAt(const glm::dvec3& eye) const;

 private:
  WalkMap map_;
  std::vector<WalkRegion> regions_;
  glm::dvec3 center_{0};
  double reach_ = 1;
  double size_ = 1;
};

/// Someone in a tunnel who walks along it. Directions are those of its axis, the way that he looks more.
struct WalkAhead {
  glm::dvec2 direction{0};            ///< of walking
  double left = 0;                    ///< from the eye to the wall on that side
  double right = 0;                   ///<
  std::optional<WalkExit> opening{};  ///< of the crossing or room ahead, through which one comes into it
  double distance = 0;                ///< to its plane
  std::optional<double> behind{};     ///< to that of the last crossing or room; nothing where a dead end lies behind
};

/// `region` must be of a tunnel. Straight tunnels that follow each other are one.
WalkAhead lookAhead(const WalkSpace& space, uint32_t region, const glm::dvec2& eye, const glm::dvec2& heading);

/// From a point to the nearest of an opening, in the plan.
double distanceTo(const WalkMouth& mouth, const glm::dvec2& point);

}  // namespace ocelli
