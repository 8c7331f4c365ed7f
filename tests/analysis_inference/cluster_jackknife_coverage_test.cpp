// How often the jackknife of clusters rejects what is true, over thousands of simulated studies.
#include <gtest/gtest.h>

#include "tests/analysis_inference/clustered_searches.h"

namespace ocelli::test {
namespace {

/// Studies of 8 subjects and 10 cases without an effect of the view in which there seems to be one.
double shareRejected(const Fit& fit, double ofCaseViews) {
  constexpr int kStudies = 4000;  // the standard error of 3 % is 0.27 %
  int rejected = 0;
  for (int study = 0; study < kStudies; ++study) {
    RandomNumbers random(7, static_cast<uint64_t>(study));
    rejected += fit(searches(8, 10, {.ofCaseViews = ofCaseViews}, random))->pValue < 0.05 ? 1 : 0;
  }
  return static_cast<double>(rejected) / kStudies;
}

TEST(ClusterJackknife, TrueNullsAreRejectedInThreeToSevenPercent) {
  for (const double ofCaseViews : {0.0, 0.8}) {
    for (const auto& [what, fit] : {std::pair("Cox", Fit(coxTerm)), std::pair("log-normal", Fit(logNormalTerm))}) {
      const double share = shareRejected(fit, ofCaseViews);
      EXPECT_GE(share, 0.03) << what << ", " << ofCaseViews;
      EXPECT_LE(share, 0.07) << what << ", " << ofCaseViews;
    }
  }
}

}  // namespace
}  // namespace ocelli::test
