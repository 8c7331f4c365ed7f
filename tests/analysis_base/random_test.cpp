#include "analysis/base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ocelli::test {
namespace {

TEST(Random, IsTheSameForTheSameSeedAndStreamAndElseAnother) {
  EXPECT_EQ(Random(7, 3).bits(), Random(7, 3).bits());
  EXPECT_NE(Random(7, 3).bits(), Random(7, 4).bits());
  EXPECT_NE(Random(7, 3).bits(), Random(8, 3).bits());
  EXPECT_NE(Random(3, 7).bits(), Random(7, 3).bits());
}

TEST(Random, DrawsEachOfAFewNumbersEquallyOften) {
  Random random(1);
  std::vector<int> counts(7);
  for (int i = 0; i < 70000; ++i) {
    ++counts[random.below(counts.size())];
  }
  for (const int count : counts) {
    EXPECT_NEAR(count, 10000, 4.5 * std::sqrt(10000.0));  // 4.5 standard deviations
  }
}

TEST(Random, DrawsNormalNumbersWithTheirMoments) {
  Random random(2);
  const int n = 200000;
  double sum = 0, squares = 0, cubes = 0, fourths = 0;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    cubes += x * x * x;
    fourths += x * x * x * x;
  }
  // 4.5 standard deviations of the means of x, x^2, x^3, x^4: of variances 1, 2, 15, 96.
  const auto near = [&](double variance) { return 4.5 * std::sqrt(variance / n); };
  EXPECT_NEAR(sum / n, 0, near(1));
  EXPECT_NEAR(squares / n, 1, near(2));
  EXPECT_NEAR(cubes / n, 0, near(15));
  EXPECT_NEAR(fourths / n, 3, near(96));
}

TEST(Random, IsNeverZeroOrOne) {
  Random random(3);
  double least = 1, largest = 0;
  for (int i = 0; i < 100000; ++i) {
    const double x = random.uniform();
    least = std::min(least, x);
    largest = std::max(largest, x);
  }
  EXPECT_GT(least, 0);
  EXPECT_LT(least, 1e-3);
  EXPECT_LT(largest, 1);
  EXPECT_GT(largest, 1 - 1e-3);
}

}  // namespace
}  // namespace ocelli::test
