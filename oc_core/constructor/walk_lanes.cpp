#include "oc_core/constructor/walk_lanes.h"

namespace ocelli {
namespace {

/// By so much more must another lane be free than one before it in the list.
constexpr double kBetter = 0.05;
/// Where so much of a lane is free no others are tried.
constexpr double kFree = 0.95;

/// Of what is worth as much as a free lane: the region's own middle.
constexpr double kFloorWorth = 0.25;

double worthOf(const WalkLanes::Found& found) {
  return found.free + kFloorWorth * found.floor;
}

size_t bestOf(const std::vector<WalkLanes::Found>& found) {
  size_t best = 0;
  for (size_t lane = 1; lane < found.size(); ++lane) {
    best = worthOf(found[lane]) > worthOf(found[best]) + kBetter ? lane : best;
  }
  return best;
}

bool isTried(const std::vector<WalkLanes::Found>& found) {
  return found.size() == walkLanes().size() ||
         (!found.empty() && worthOf(found[bestOf(found)]) >= kFree * (1 + kFloorWorth));
}

}  // namespace

const std::vector<PieceLane>& walkLanes() {
  static const std::vector<PieceLane> lanes{
      {},
      {.straight = 0.7},
      {.aside = -1},
      {.aside = 1},
      {.top = 0.6},
      {.straight = 0.7, .top = 0.6},
      {.top = 0.4},
      {.before = 0.5},
      {.aside = -1, .straight = 0.7},
      {.aside = 1, .straight = 0.7},
      {.around = -0.25},
      {.around = 0.25},
      {.before = 2},
      {.into = 0.2},
      {.into = 0.7},
      {.around = -0.5},
      {.around = 0.5},
      {.aside = -1, .before = 0.5},
      {.aside = 1, .before = 0.5},
      {.before = 0.5, .straight = 0.7},
      {.straight = 1.2},
      {.aside = -1, .around = -0.25},
      {.aside = 1, .around = 0.25},
  };
  return lanes;
}

size_t WalkLanes::laneOf(const LaneWay& way) const {
  const auto found = found_.find(way);
  if (found == found_.end()) {
    return 0;
  }
  return isTried(found->second) ? bestOf(found->second) : found->second.size();
}

bool WalkLanes::note(const LaneWay& way, size_t lane, const Found& found) {
  std::vector<Found>& all = found_[way];
  if (lane == all.size()) {
    all.push_back(found);
  } else {
    all[lane] = found;
  }
  return !isTried(all);
}

double WalkLanes::freeOf(const LaneWay& way) const {
  const auto found = found_.find(way);
  return found == found_.end() || !isTried(found->second) ? 1 : found->second[bestOf(found->second)].free;
}

}  // namespace ocelli
