#include "oc_core/constructor/walk_tour.h"

#include <deque>

namespace ocelli {

WalkTour walkTourOf(const std::vector<WalkRegion>& regions, uint32_t start, TourOrder order,
                    const std::function<bool(const WalkTour::Stop&, const WalkExit&, uint32_t region)>& isBlocked) {
  WalkTour tour;
  tour.stops.resize(regions.size());
  struct Way {
    int parent;
    WalkExit exit;
    size_t steps;
  };
  std::deque<Way> pending{{-1, {0, regions[start].cell, start, {}}, 0}};
  std::deque<Way> blocked;
  while (!pending.empty() || !blocked.empty()) {
    std::deque<Way>& from = pending.empty() ? blocked : pending;
    const Way way = from.front();
    from.pop_front();
    const uint32_t region = way.exit.region;
    WalkTour::Stop& stop = tour.stops[region];
    if (stop.reached) {
      continue;
    }
    stop = {way.parent, way.exit, way.steps, true};
    tour.order.push_back(region);
    if (way.parent >= 0) {
      tour.stops[static_cast<size_t>(way.parent)].next.push_back(region);
    }
    std::vector<Way> ways;
    std::vector<Way> blockedHere;
    for (const WalkExit& exit : regions[region].exits) {
      if (!tour.stops[exit.region].reached) {
        (isBlocked && isBlocked(stop, exit, region) ? blockedHere : ways)
            .push_back({static_cast<int>(region), exit, way.steps + 1});
      }
    }
    pending.insert(order == TourOrder::kBreadthFirst ? pending.end() : pending.begin(), ways.begin(), ways.end());
    blocked.insert(blocked.end(), blockedHere.begin(), blockedHere.end());
  }
  return tour;
}

}  // namespace ocelli
