// The shop (`builtin:shop`): one camera over the main aisle; those that look into the side aisles stand as far back as
// the aisles across from them let them, that of the cross aisle in its other half.
#include "oc_core/feeds_measure/feed_rigs.h"

namespace ocelli {
namespace {

constexpr glm::ivec2 kShopSize{1280, 720};
constexpr double kShopBoard = 2.4;  ///< the lower edge of the boards over the openings

/// The opening of a side aisle, which reaches from its floor to its board.
std::array<glm::dvec3, 4> sideOpening(double x) {
  return {{{x, 0, 4.6}, {x, kShopBoard, 4.6}, {x, kShopBoard, 2.4}, {x, 0, 2.4}}};
}

FeedSetup shopSetup() {
  FeedSetup setup;
  setup.feeds = {rigFeed("main", kShopSize, 800, {0, 2.85, 8.2}, {0, 1.2, 0}),
                 rigFeed("left", kShopSize, 1350, {6.6, 2.38, 3.5}, {-1.6, 1.2, 3.5}),
                 rigFeed("right", kShopSize, 1350, {-6.6, 2.38, 3.5}, {1.6, 1.2, 3.5}),
                 rigFeed("back", kShopSize, 1200, {-6.6, 2.65, -2.1}, {1.6, 0.75, -2.1})};
  setup.frusta = {
      {"main", "", {}},
      {"left", "main", sideOpening(-1.6)},
      {"right", "main", sideOpening(1.6)},
      {"back", "main", {{{1.6, 0, -1}, {1.6, kShopBoard, -1}, {-1.2, 2.3, -3.2}, {-1.2, 0, -3.2}}}},
  };
  setup.output = {1280, 720, 46, {0, 1.2, 0}};
  return setup;
}

WalkWays shopWays() {
  WalkWays ways;
  ways.places = {{0, 6.4}, {0, 3.5}, {0, -2.1}, {-5.6, 3.5}, {5.6, 3.5}, {5.6, -2.1}, {-3.6, -2.1}};
  ways.neighbours = {{1}, {0, 2, 3, 4}, {1, 5, 6}, {1}, {1}, {2}, {2}};
  ways.halfWidth = 0.55;
  return ways;
}

}  // namespace

FeedRig shopRig() {
  return {"shop", shopSetup, shopWays};
}

}  // namespace ocelli
