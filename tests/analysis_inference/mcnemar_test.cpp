#include "analysis/inference/mcnemar.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

void expectTest(const PairedCounts& counts, const std::string& name) {
  const McNemarTest test = *mcNemarTest(counts);
  expectGolden({test.exactP, test.midP, test.chiSquared.statistic, test.chiSquaredCorrected.statistic,
                test.oddsRatio->value, test.oddsRatio->lower, test.oddsRatio->upper, test.difference.value,
                test.difference.lower, test.difference.upper},
               name, kClosedForm);
}

TEST(McNemar, IsMcnemarTestAndBinomTest) {
  expectTest({40, 6, 25, 19, 0}, "mcnemar/large");
  expectTest({3, 1, 4, 2, 0}, "mcnemar/small");
}

TEST(McNemar, PairsTrialsByTheirKeys) {
  const PairedCounts counts = pairOutcomes({{"S1 scene 1", false, true},
                                            {"S1 scene 2", true, true},
                                            {"S1 scene 1", true, false},
                                            {"S1 scene 2", false, true},
                                            {"S2 scene 1", true, true},
                                            {"S2 scene 2", true, true},
                                            {"S2 scene 2", false, false}});
  EXPECT_EQ(counts.onlyFirst, 1);
  EXPECT_EQ(counts.both, 1);
  EXPECT_EQ(counts.onlySecond, 1);
  EXPECT_EQ(counts.neither, 0);
  EXPECT_EQ(counts.unpaired, 1);
  EXPECT_EQ(counts.pairs(), 3);
  EXPECT_THROW(pairOutcomes({{"a", true, true}, {"a", true, false}}), InputError);
}

TEST(McNemar, SaysWhatItLacks) {
  EXPECT_EQ(mcNemarTest({10, 0, 0, 5, 0}).reason(),
            "none of 15 pairs has a success in one condition and none in the other");
  const McNemarTest oneWay = *mcNemarTest({10, 0, 8, 5, 0});
  EXPECT_EQ(oneWay.oddsRatio.reason(), "no pair succeeded in the first condition alone");
  EXPECT_DOUBLE_EQ(oneWay.exactP, 2.0 / 256);
}

}  // namespace
}  // namespace ocelli::test
