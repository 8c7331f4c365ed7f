// The order in which a camera that shows all cells of a walk map goes through them: a tree from a start, in which each
// cell has one that comes before it (section 4.3.2.2).
#pragma once

#include <cstddef>
#include <vector>

#include "oc_core/constructor/maze_tour.h"
#include "oc_core/constructor/walk_region.h"

namespace ocelli {

struct WalkTour {
  struct Stop {
    int parent = -1;               ///< the region before it
    WalkExit way{};                ///< from there
    size_t steps = 0;              ///< regions before it
    bool reached = false;          ///< from the start
    std::vector<uint32_t> next{};  ///< regions that come after it
  };
  std::vector<uint32_t> order;  ///< of the regions that are reached, parents before their children
  std::vector<Stop> stops;      ///< of each region
};

/// `start` must be a region. The exits of regions lead the way. Those of which `isBlocked` says so, given how one came
/// into a region and the exit, are taken only where no others lead on.
WalkTour walkTourOf(const std::vector<WalkRegion>& regions, uint32_t start, TourOrder order,
                    const std::function<bool(const WalkTour::Stop&, const WalkExit&, uint32_t region)>& isBlocked = {});

}  // namespace ocelli
