#include "analysis/plot/swarm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/analysis_plot/sample_figures.h"

namespace ocelli {
namespace {

std::vector<double> places(size_t count) {
  SampleNumbers numbers(11);
  std::vector<double> values;
  for (size_t i = 0; i < count; ++i) {
    values.push_back(100 * numbers.uniform());
  }
  return values;
}

TEST(Swarm, noPointHidesAnother) {
  const std::vector<double> at = places(150);
  const std::vector<double> offsets = swarmOffsets(at, 3, 1000);
  for (size_t i = 0; i < at.size(); ++i) {
    for (size_t k = 0; k < i; ++k) {
      EXPECT_GE(std::hypot(at[i] - at[k], offsets[i] - offsets[k]), 3 * (1 - 1e-6));
    }
  }
}

TEST(Swarm, staysInItsWidthAndDoesNotDependOnTheOrder) {
  std::vector<double> at = places(400);
  std::vector<double> offsets = swarmOffsets(at, 3, 12);
  EXPECT_NEAR(std::abs(*std::max_element(offsets.begin(), offsets.end(),
                                         [](double a, double b) { return std::abs(a) < std::abs(b); })),
              12, 1e-9);
  std::reverse(at.begin(), at.end());
  std::vector<double> reversed = swarmOffsets(at, 3, 12);
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_EQ(offsets, reversed);
}

TEST(Swarm, equalValuesStandSideBySideAroundTheMiddle) {
  EXPECT_THAT(swarmOffsets({5, 5, 5}, 2, 100), testing::UnorderedElementsAre(0, 2, -2));
  EXPECT_THAT(swarmOffsets({}, 2, 100), testing::IsEmpty());
}

TEST(Swarm, ofManyValuesTheEndsAreDrawn) {
  std::vector<double> values = places(5000);
  values[7] = std::numeric_limits<double>::quiet_NaN();
  values[8] = 1e6;
  values[9] = -1e6;
  const std::vector<size_t> drawn = drawnPoints(values, 100);
  EXPECT_EQ(drawn.size(), 100U);
  EXPECT_THAT(drawn, testing::Contains(8U));
  EXPECT_THAT(drawn, testing::Contains(9U));
  EXPECT_THAT(drawn, testing::Not(testing::Contains(7U)));
}

}  // namespace
}  // namespace ocelli
