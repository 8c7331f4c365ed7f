#include "oc_core/base/random_numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ocelli {
namespace {

// The first outputs of xoshiro256** from the state that splitmix64 gives for seed 0; splitmix64's first is published.
TEST(RandomNumbers, AreThoseOfTheSeed) {
  RandomNumbers numbers(0);
  EXPECT_EQ(numbers.bits(), 0x99ec5f36cb75f2b4u);
  EXPECT_EQ(numbers.bits(), 0xbf6e1f784956452au);
  EXPECT_NE(RandomNumbers(1, 2).bits(), RandomNumbers(1, 3).bits());
  EXPECT_NE(RandomNumbers(1, 2).bits(), RandomNumbers(2, 2).bits());
  EXPECT_EQ(RandomNumbers(1, 2).bits(), RandomNumbers(1, 2).bits());
}

// Moments within 5 standard errors.
TEST(RandomNumbers, HaveTheMomentsOfTheirDistributions) {
  RandomNumbers numbers(5);
  const int count = 100000;
  double uniform = 0;
  double normal = 0;
  double squared = 0;
  double fourth = 0;
  std::array<int, 3> drawn{};
  for (int i = 0; i < count; ++i) {
    uniform += numbers.uniform() / count;
    const double x = numbers.normal();
    normal += x / count;
    squared += x * x / count;
    fourth += std::pow(x, 4) / count;
    ++drawn[numbers.below(3)];
  }
  const double root = std::sqrt(count);
  EXPECT_NEAR(uniform, 0.5, 5 / (std::sqrt(12) * root));
  EXPECT_NEAR(normal, 0, 5 / root);
  EXPECT_NEAR(squared, 1, 5 * std::sqrt(2) / root);
  EXPECT_NEAR(fourth, 3, 5 * std::sqrt(96) / root);
  for (const int each : drawn) {
    EXPECT_NEAR(each, count / 3.0, 5 * std::sqrt(count * 2 / 9.0));
  }
}

}  // namespace
}  // namespace ocelli
