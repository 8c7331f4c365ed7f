// The T of corridors (`builtin:corridor_t`): the stem's camera looks at the crossing, those of the branches stand as
// far back as the other branch lets them (section 4.3.3: "A narrow field-of-view is also desirable").
#include "oc_core/feeds_measure/feed_rigs.h"

namespace ocelli {
namespace {

constexpr double kTHeight = 2.8;
constexpr glm::ivec2 kTSize{640, 480};

FeedSetup corridorTSetup() {
  FeedSetup setup;
  setup.feeds = {rigFeed("stem", kTSize, 600, {0, 2.3, 5.2}, {0, 1.2, -2.4}),
                 rigFeed("left", kTSize, 660, {5, 2.7, -1.2}, {-1, 1.1, -1.2}),
                 rigFeed("right", kTSize, 660, {-5, 2.7, -1.2}, {1, 1.1, -1.2})};
  const auto face = [](double x) {
    return std::array<glm::dvec3, 4>{{{x, 0, 0}, {x, kTHeight, 0}, {0, kTHeight, -2.4}, {0, 0, -2.4}}};
  };
  setup.frusta = {{"stem", "", {}}, {"left", "stem", face(-1.2)}, {"right", "stem", face(1.2)}};
  setup.output = {640, 480, 42, {0, 1.2, -2.4}};
  return setup;
}

WalkWays corridorTWays() {
  WalkWays ways;
  ways.places = {{0, 3.6}, {0, -1.2}, {-8, -1.2}, {8, -1.2}};
  ways.neighbours = {{1}, {0, 2, 3}, {1}, {1}};
  ways.halfWidth = 0.6;
  return ways;
}

}  // namespace

FeedRig corridorTRig() {
  return {"corridor_t", corridorTSetup, corridorTWays};
}

}  // namespace ocelli
