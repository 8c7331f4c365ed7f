// The corridor with two corners (`builtin:corridor`): the cameras behind each corner stand in its niche, and look along
// the part that follows.
#include "oc_core/feeds_measure/feed_rigs.h"

namespace ocelli {
namespace {

constexpr double kZHeight = 2.8;
constexpr glm::ivec2 kZSize{640, 480};

FeedSetup corridorSetup() {
  FeedSetup setup;
  setup.feeds = {rigFeed("first", kZSize, 560, {0, 2.3, 5.2}, {0.3, 1.2, -2.4}),
                 rigFeed("second", kZSize, 640, {-4.4, 2.65, -1.2}, {2, 0.85, -1.2}),
                 rigFeed("third", kZSize, 640, {5.6, 2.65, 3.6}, {5.6, 0.9, -3})};
  setup.frusta = {
      {"first", "", {}},
      {"second", "first", {{{1.2, 0, 0}, {1.2, kZHeight, 0}, {-0.1, kZHeight, -2.4}, {-0.1, 0, -2.4}}}},
      {"third", "second", {{{4.4, 0, -2.4}, {4.4, kZHeight, -2.4}, {6.8, kZHeight, -1}, {6.8, 0, -1}}}},
  };
  setup.output = {640, 480, 40, {0.4, 1.2, -2.4}};
  return setup;
}

WalkWays corridorWays() {
  WalkWays ways;
  ways.places = {{0, 3.6}, {0, -1.2}, {5.6, -1.2}, {5.6, -8.8}};
  ways.neighbours = {{1}, {0, 2}, {1, 3}, {2}};
  ways.halfWidth = 0.6;
  return ways;
}

}  // namespace

FeedRig corridorRig() {
  return {"corridor", corridorSetup, corridorWays};
}

}  // namespace ocelli
