// By which lane rays go through a region to each of its exits, where something may stand in the way. Lanes are tried
// one after the other, an image each, in all regions at once: how much of a lane is free depends little on what comes
// before it. Then each exit has that of which most was free when it was last built, or a little less where it shows
// more of the region itself.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "oc_core/constructor/walk_piece.h"

namespace ocelli {

/// The first is the usual one.
const std::vector<PieceLane>& walkLanes();

/// From the opening that rays come in by to another one, which are portals of the map.
struct LaneWay {
  uint32_t region = 0;
  uint32_t entry = 0;
  uint32_t exit = 0;

  auto operator<=>(const LaneWay&) const = default;
};

class WalkLanes {
 public:
  /// The one for the next image.
  size_t laneOf(const LaneWay& way) const;
  struct Found {
    double free = 0;   ///< the share of its rays that got through
    double floor = 0;  ///< how much of the region's own middle it shows, from 0 to 1
  };
  /// Of an image with that lane. Returns whether lanes of this way are still to be tried.
  bool note(const LaneWay& way, size_t lane, const Found& found);
  /// By the best lane; 1 where not all have been tried.
  double freeOf(const LaneWay& way) const;

 private:
  std::map<LaneWay, std::vector<Found>> found_;  ///< of each lane that was tried
};

}  // namespace ocelli
