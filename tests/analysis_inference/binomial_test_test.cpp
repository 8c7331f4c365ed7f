#include "analysis/inference/binomial_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "oc_core/base/error.h"
#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

TEST(BinomialTest, IsBinomTestAndPropTest) {
  for (const int successes : {0, 12, 30}) {
    const BinomialTest test = *binomialTest({successes, 30}, 1.0 / 3);
    const double z = test.wilson.statistic;
    expectGolden(
        {test.clopperPearson.value, test.clopperPearson.lower, test.clopperPearson.upper, test.clopperPearson.pValue,
         test.wilson.lower, test.wilson.upper, z * z, test.wilson.pValue, test.pAbove},
        "binomial/" + std::to_string(successes), kClosedForm);
  }
  const Estimate ninety = clopperPearsonShare({7, 20}, 0.9);
  expectGolden({ninety.lower, ninety.upper}, "binomial/90", kClosedForm);
}

TEST(BinomialTest, KeepsTheDigitsOfSmallChances) {
  EXPECT_NEAR(binomialTest({30, 30}, 1.0 / 3)->pAbove / std::pow(3, -30), 1, 1e-10);
}

TEST(BinomialTest, SaysWhatItLacks) {
  EXPECT_EQ(binomialTest({0, 0}, 0.5).reason(), "there are no trials");
  EXPECT_THROW(binomialTest({3, 2}, 0.5), InputError);
  EXPECT_THROW(binomialTest({1, 2}, 1), InputError);
}

}  // namespace
}  // namespace ocelli::test
