// The T of corridors (`builtin:corridor_t`): the stem's camera looks at the crossing, those of the branches stand as
// far back as the other branch lets them (section 4.3.3: "A narrow field-of-view is also desirable").
#include "oc_core/feeds_measure/feed_rigs.h"

namespace ocelli {
namespace {

constexpr double kHeight = 2.8;

Feed rigFeed(const std::string& name, double focal, const glm::dvec3& eye, const glm::dvec3& target) {
  Feed feed;
  feed.name = name;
  feed.source = name + ".mkv";
  feed.background = name + ".png";
  feed.lens.focal = {focal, focal};
  feed.lens.center = {feed.width / 2.0, feed.height / 2.0};
  feed.pose = {eye, target, {0, 1, 0}};
  return feed;
}

FeedSetup corridorSetup() {
  FeedSetup setup;
  setup.feeds = {rigFeed("stem", 600, {0, 2.3, 5.2}, {0, 1.2, -2.4}),
                 rigFeed("left", 660, {5, 2.7, -1.2}, {-1, 1.1, -1.2}),
                 rigFeed("right", 660, {-5, 2.7, -1.2}, {1, 1.1, -1.2})};
  const auto face = [](double x) {
    return std::array<glm::dvec3, 4>{{{x, 0, 0}, {x, kHeight, 0}, {0, kHeight, -2.4}, {0, 0, -2.4}}};
  };
  setup.frusta = {{"stem", "", {}}, {"left", "stem", face(-1.2)}, {"right", "stem", face(1.2)}};
  setup.output = {640, 480, 42, {0, 1.2, -2.4}};
  return setup;
}

WalkWays corridorWays() {
  WalkWays ways;
  ways.places = {{0, 3.6}, {0, -1.2}, {-8, -1.2}, {8, -1.2}};
  ways.neighbours = {{1}, {0, 2, 3}, {1}, {1}};
  ways.halfWidth = 0.6;
  return ways;
}

}  // namespace

FeedRig corridorRig() {
  return {"corridor_t", corridorSetup, corridorWays};
}

}  // namespace ocelli
