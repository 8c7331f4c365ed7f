#include "oc_core/feeds_measure/walker_fates.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace ocelli {
namespace {

WalkerArea areaOf(double root, double branch) {
  WalkerArea area;
  area.pixels = {root, branch};
  return area;
}

TEST(WalkerFates, FollowWhereAWalkerIsSeen) {
  const WalkerArea wanted = areaOf(0, 1000);
  const WalkerArea nothing = areaOf(0, 0);
  EXPECT_EQ(fateOf(wanted, areaOf(0, 900), wanted, false), WalkerFate::kRight);
  EXPECT_EQ(fateOf(wanted, areaOf(300, 900), wanted, false), WalkerFate::kDoubled);
  EXPECT_EQ(fateOf(wanted, areaOf(300, 100), wanted, false), WalkerFate::kMisplaced);
  EXPECT_EQ(fateOf(wanted, nothing, wanted, false), WalkerFate::kMissing);
  EXPECT_EQ(fateOf(wanted, nothing, nothing, false), WalkerFate::kHidden);
  EXPECT_EQ(fateOf(wanted, areaOf(400, 100), wanted, true), WalkerFate::kBetween);
  EXPECT_EQ(fateOf(wanted, nothing, wanted, true), WalkerFate::kMissing);
  EXPECT_EQ(fateOf(nothing, areaOf(0, 500), nothing, false), WalkerFate::kGhost);
  EXPECT_EQ(fateOf(nothing, nothing, nothing, false), WalkerFate::kRight);
}

TEST(WalkerFates, HaveNamesAndMeaningsOfTheirOwn) {
  std::set<std::string> names;
  std::set<std::string> meanings;
  for (size_t i = 0; i < kWalkerFates; ++i) {
    names.insert(nameOf(static_cast<WalkerFate>(i)));
    meanings.insert(meaningOf(static_cast<WalkerFate>(i)));
  }
  EXPECT_EQ(names.size(), kWalkerFates);
  EXPECT_EQ(meanings.size(), kWalkerFates);
}

TEST(WalkerAreas, BoxHoldsAllPixels) {
  WalkerArea area = emptyAreas(2, 3)[1];
  EXPECT_TRUE(area.isEmpty());
  area.add(2, 7, 9);
  area.add(0, 3, 20);
  EXPECT_EQ(area.all(), 2);
  EXPECT_EQ(area.pixels[2], 1);
  EXPECT_EQ(area.left, 3);
  EXPECT_EQ(area.right, 8);
  EXPECT_EQ(area.top, 9);
  EXPECT_EQ(area.bottom, 21);
}

}  // namespace
}  // namespace ocelli
