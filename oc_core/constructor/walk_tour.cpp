#include "oc_core/constructor/walk_tour.h"

#include <deque>

namespace ocelli {

WalkTour walkTourOf(const std::vector<WalkRegion>& regions, uint32_t start, TourOrder order) {
  WalkTour tour;
  tour.stops.resize(regions.size());
  struct Way {
    int parent;
    WalkExit exit;
    size_t steps;
  };
  std::deque<Way> pending{{-1, {0, start, {}}, 0}};
  while (!pending.empty()) {
    const Way way = pending.front();
    pending.pop_front();
    const uint32_t cell = way.exit.cell;
    WalkTour::Stop& stop = tour.stops[cell];
    if (stop.reached) {
      continue;
    }
    stop = {way.parent, way.exit, way.steps, true};
    tour.order.push_back(cell);
    if (way.parent >= 0) {
      tour.stops[static_cast<size_t>(way.parent)].next.push_back(cell);
    }
    std::vector<Way> ways;
    for (const WalkExit& exit : regions[cell].exits) {
      if (!tour.stops[exit.cell].reached) {
        ways.push_back({static_cast<int>(cell), exit, way.steps + 1});
      }
    }
    pending.insert(order == TourOrder::kBreadthFirst ? pending.end() : pending.begin(), ways.begin(), ways.end());
  }
  return tour;
}

}  // namespace ocelli
