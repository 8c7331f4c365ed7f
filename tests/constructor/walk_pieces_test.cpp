#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "oc_core/constructor/walk_comprehensive.h"
#include "oc_core/constructor/walk_fans.h"
#include "tests/constructor/walk_maps.h"

namespace ocelli {
namespace {

bool aimsAt(const std::vector<FanAim>& aims, int exit) {
  return std::any_of(aims.begin(), aims.end(), [exit](const FanAim& aim) { return aim.exit == exit; });
}

WalkComprehensiveOptions northFromTheFirstCell() {
  WalkComprehensiveOptions options;
  options.start = WalkStart{0, {0, 0, -1}};
  return options;
}

TEST(WalkPieces, exitsThatLookBackAreLeftOut) {
  const WalkMouth entry{{0, 0}, {1, 0}, 0, 2};
  const EntryFrame frame(entry);
  const WalkMouth ahead{frame.inPlan({0.2, 3}), frame.inPlan({0.5, 3}), 0, 2};
  const WalkMouth other{frame.inPlan({0.6, 3}), frame.inPlan({0.9, 3}), 0, 2};
  EXPECT_TRUE(aimsAt(aimsOf(frame, 1, {ahead, other}), 1));
  const std::vector<FanAim> aims = aimsOf(frame, 1, {ahead, other.reversed()});
  EXPECT_TRUE(aimsAt(aims, 0));
  EXPECT_FALSE(aimsAt(aims, 1));
}

TEST(WalkPieces, whatCannotBeReachedTakesNoRays) {
  test::PlannedHouse house;
  house.cells = {{{-4, 0}, {4, 5}}, {{-4, -5}, {4, -0.2f}}};
  house.doors = {{0, 1, -2, 1}};
  const ComprehensiveWalk without = makeComprehensiveWalk(house.map(), northFromTheFirstCell(), 960, 600);
  house.cells.push_back({{20, 0}, {24, 5}});  // without a door
  const ComprehensiveWalk walk = makeComprehensiveWalk(house.map(), northFromTheFirstCell(), 960, 600);
  EXPECT_EQ(walk.cells[2].unseen, WalkUnseen::kNoWay);
  for (const size_t cell : {0, 1}) {
    EXPECT_EQ(walk.cells[cell].unseen, WalkUnseen::kNothing);
    EXPECT_NEAR(walk.cells[cell].pixels, without.cells[cell].pixels, 1e-6 * without.cells[cell].pixels);
  }
}

TEST(WalkPieces, eachReasonHasItsText) {
  std::set<std::string> texts;
  for (int why = 0; why <= static_cast<int>(WalkUnseen::kHidden); ++why) {
    EXPECT_TRUE(texts.insert(textOf(static_cast<WalkUnseen>(why))).second);
  }
  EXPECT_STREQ(textOf(WalkUnseen::kNoRays), "no rays come in");
  EXPECT_STREQ(textOf(WalkUnseen::kTooFewPixels), "too few pixels are left for it");
}

}  // namespace
}  // namespace ocelli
