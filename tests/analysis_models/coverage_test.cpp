// How often 95 % intervals hold the truth, and how often a true null is rejected, over studies made by seed.
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>

#include "analysis/models/binomial_mixed_model.h"
#include "tests/analysis_models/sample_models.h"

namespace ocelli {
namespace {

using Eigen::VectorXd;

struct Coverage {
  int studies = 0;
  int failed = 0;                ///< not fitted, or did not converge
  std::array<int, 4> covered{};  ///< of each coefficient
  int rejected = 0;              ///< the last one is 0 in truth
};

/// `estimate(study, index)`: of coefficient `index` of a study, or nothing.
template <class Study>
Coverage coverageOf(int studies, const VectorXd& truth, const Study& study) {
  std::vector<std::vector<Estimate>> all(static_cast<size_t>(studies));
  tbb::parallel_for(size_t{0}, all.size(), [&](size_t index) { all[index] = study(index); });
  Coverage coverage;
  coverage.studies = studies;
  for (const std::vector<Estimate>& estimates : all) {
    coverage.failed += estimates.empty() ? 1 : 0;
    for (size_t i = 0; i < estimates.size(); ++i) {
      const double value = truth[static_cast<Eigen::Index>(i)];
      coverage.covered[i] += estimates[i].lower <= value && value <= estimates[i].upper ? 1 : 0;
    }
    coverage.rejected += !estimates.empty() && estimates[3].pValue < 0.05 ? 1 : 0;
  }
  return coverage;
}

/// Within `slack` and 3.5 standard errors of a share of 95 %.
void expectNominal(const Coverage& coverage, double slack) {
  const double fitted = coverage.studies - coverage.failed;
  EXPECT_LE(coverage.failed, coverage.studies / 100);
  const double tolerance = slack + 3.5 * std::sqrt(0.95 * 0.05 / fitted);
  for (const int covered : coverage.covered) {
    EXPECT_NEAR(covered / fitted, 0.95, tolerance);
  }
  EXPECT_NEAR(coverage.rejected / fitted, 0.05, tolerance);
}

template <class Fit>
std::vector<Estimate> estimatesOf(const Estimable<Fit>& fit) {
  std::vector<Estimate> estimates;
  if (fit && fit->convergence.converged) {
    for (Eigen::Index i = 0; i < 4; ++i) {
      estimates.push_back(contrastEstimate(*fit, VectorXd::Unit(4, i)));
    }
  }
  return estimates;
}

/// Log times: subjects with slopes of the view, crossed with locations; the session has no effect.
void expectLinearCoverage(int subjects) {
  const LinearMixedModel model(sampleDesign({subjects, 12, 2}));
  LinearMixedFit truth = sampleLinearTruth();
  truth.coefficients[3] = 0;
  expectNominal(coverageOf(600, truth.coefficients,
                           [&](size_t index) {
                             RandomNumbers numbers(100, index);
                             return estimatesOf(model.fit(model.simulate(truth, numbers)));
                           }),
                0);
}

TEST(Coverage, OfLogTimesOf20Subjects) {
  expectLinearCoverage(20);
}

TEST(Coverage, OfLogTimesOf45Subjects) {
  expectLinearCoverage(45);
}

template <class Fit>
void expectBinomialCoverage(int studies, double slack, const Fit& fit) {
  const BinomialMixedModel model(sampleDesign({45, 20, 1}));
  BinomialMixedFit truth = sampleBinomialTruth();
  truth.coefficients[3] = 0;
  expectNominal(coverageOf(studies, truth.coefficients,
                           [&](size_t index) {
                             RandomNumbers numbers(200, index);
                             const VectorXd trials = VectorXd::Ones(model.design().rows());
                             return estimatesOf(fit(model, model.simulate(truth, trials, numbers)));
                           }),
                slack);
}

// Wald's intervals take variances for known: those of what differs between 20 items are short.
TEST(Coverage, OfCountsByMaximumLikelihood) {
  expectBinomialCoverage(
      300, 0.03, [](const BinomialMixedModel& model, const BinomialResponse& response) { return model.fit(response); });
}

TEST(Coverage, OfCountsByRestrictedLikelihood) {
  expectBinomialCoverage(600, 0, [](const BinomialMixedModel& model, const BinomialResponse& response) {
    return model.fitRestricted(response);
  });
}

}  // namespace
}  // namespace ocelli
