// The court (`builtin:courtyard`): one camera high over its south end; those that look into the arcades stand under the
// windows of the sides across, that of the lane behind the gate in the lane's other half.
#include "oc_core/feeds_measure/feed_rigs.h"

namespace ocelli {
namespace {

constexpr glm::ivec2 kCourtSize{960, 600};
constexpr double kCourtLintel = 2.8;  ///< height of the openings between the columns

/// All openings of an arcade from z = -9 to -1, in the plane of the wall over its columns.
std::array<glm::dvec3, 4> arcadeOpening(double x) {
  return {{{x, 0, -1}, {x, kCourtLintel, -1}, {x, kCourtLintel, -9}, {x, 0, -9}}};
}

FeedSetup courtyardSetup() {
  FeedSetup setup;
  setup.feeds = {rigFeed("court", kCourtSize, 640, {0, 4.4, 4.7}, {0, 0.9, -6}),
                 rigFeed("left", kCourtSize, 760, {3.8, 3.6, -5}, {-5, 1.2, -5}),
                 rigFeed("right", kCourtSize, 760, {-3.8, 3.6, -5}, {5, 1.2, -5}),
                 rigFeed("lane", kCourtSize, 900, {-6.8, 2.9, -10.5}, {1.2, 1.0, -10.5})};
  setup.frusta = {
      {"court", "", {}},
      {"left", "court", arcadeOpening(-4)},
      {"right", "court", arcadeOpening(4)},
      {"lane", "court", {{{1.2, 0, -9.2}, {1.2, 2.85, -9.2}, {-1.2, 2.6, -11.8}, {-1.2, 0, -11.8}}}},
  };
  setup.output = {960, 600, 46, {0, 1.0, -6}};
  return setup;
}

WalkWays courtyardWays() {
  WalkWays ways;
  ways.places = {{0, 1},     {0, -2},   {0, -6},   {0, -10.5}, {5, -10.5}, {-5.2, -6},
                 {-5.2, -8}, {5.2, -2}, {5.2, -6}, {5.2, -8},  {-5.2, -2}};
  ways.neighbours = {{1}, {0, 2, 7, 10}, {1, 3, 5, 8}, {2, 4}, {3}, {2, 6, 10}, {5}, {1, 8}, {2, 7, 9}, {8}, {1, 5}};
  ways.halfWidth = 0.4;
  return ways;
}

}  // namespace

FeedRig courtyardRig() {
  return {"courtyard", courtyardSetup, courtyardWays};
}

}  // namespace ocelli
