#include "analysis/inference/censored_difference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/inference/accelerated_failure_time.h"
#include "oc_core/base/random_numbers.h"

namespace ocelli {
namespace {

struct Drawn {
  CensoredSums first;
  CensoredSums second;
  SurvivalData data;
};

/// Log times of two groups, stopped at 3 (of some at 2.7).
Drawn drawn(uint64_t seed) {
  RandomNumbers numbers(seed);
  Drawn result;
  Covariate group{"group", {}};
  for (int i = 0; i < 80; ++i) {
    const bool second = i % 2 == 1;
    const double limit = i % 7 == 0 ? 2.7 : 3;
    const double value = 2.6 + (second ? 0.4 : 0) + 0.5 * numbers.normal();
    (second ? result.second : result.first).add(std::min(value, limit), value > limit);
    result.data.times.push_back({std::exp(std::min(value, limit)), value <= limit});
    group.values.push_back(second ? 1 : 0);
  }
  result.data.covariates = {group};
  return result;
}

/// The same likelihood, in other coordinates: both end where a step promises nothing any more.
TEST(CensoredDifference, isTheLogTimeRatioOfTheLogNormalRegression) {
  for (const uint64_t seed : {1u, 2u, 3u}) {
    const Drawn each = drawn(seed);
    const auto fit = fitLogNormal(each.data);
    ASSERT_TRUE(fit);
    const std::optional<double> difference = censoredMeanDifference(each.first, each.second);
    ASSERT_TRUE(difference);
    EXPECT_NEAR(*difference, fit->terms[0].logTimeRatio.value, 1e-5);
  }
}

TEST(CensoredDifference, isThatOfTheMeansWithoutCensoredValues) {
  CensoredSums first;
  CensoredSums second;
  for (const double value : {1.0, 2.0, 4.5}) {
    first.add(value, false);
    second.add(value * 2 + 0.25, false);
  }
  EXPECT_NEAR(*censoredMeanDifference(first, second), 2.75, 1e-9);
}

TEST(CensoredDifference, needsValuesOfBothGroupsThatVary) {
  CensoredSums first;
  CensoredSums second;
  first.add(1, false);
  second.add(3, true);
  EXPECT_FALSE(censoredMeanDifference(first, second));
  second.add(2, false);
  EXPECT_FALSE(censoredMeanDifference(first, second));
  second.add(2.5, false);
  EXPECT_TRUE(censoredMeanDifference(first, second));
}

}  // namespace
}  // namespace ocelli
