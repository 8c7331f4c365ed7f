#include "oc_core/base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace ocelli {
namespace {

TEST(Random, isThePublishedSplitMix) {
  // The first outputs for seed 1234567, as printed with the generator's reference implementation.
  Random random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317u);
  EXPECT_EQ(random.next(), 3203168211198807973u);
  EXPECT_EQ(random.next(), 9817491932198370423u);
}

TEST(Random, staysInRange) {
  Random random(1);
  std::vector<size_t> counts(7);
  float least = 5;
  float most = 2;
  for (int i = 0; i < 70'000; ++i) {
    ++counts.at(random.below(counts.size()));
    const float x = random.inRange(2, 5);
    least = std::min(least, x);
    most = std::max(most, x);
  }
  EXPECT_GE(least, 2.0f);
  EXPECT_LE(most, 5.0f);
  EXPECT_LT(least, 2.001f);  // 70,000 draws miss the lowest 3000th with probability e^-23
  EXPECT_GT(most, 4.999f);
  for (const size_t count : counts) {
    EXPECT_NEAR(static_cast<double>(count), 10'000.0, 500.0);  // 5.4 standard deviations of 93
  }
}

TEST(Random, shufflesEveryElementOnce) {
  std::vector<int> list(100);
  std::iota(list.begin(), list.end(), 0);
  const std::vector<int> sorted = list;
  Random(3).shuffle(list);
  EXPECT_NE(list, sorted);
  std::sort(list.begin(), list.end());
  EXPECT_EQ(list, sorted);
  std::vector<int> none;
  Random(3).shuffle(none);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace ocelli
