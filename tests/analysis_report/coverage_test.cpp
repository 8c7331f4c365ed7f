// Whether 95 % intervals of the report hold the truth in 93 to 97 % of studies, and a true null is rejected in 3.5 to
// 6.5 %: fewer studies than bench/simulated_studies_bench.cpp has, by the same code. A share is accepted unless one in
// those ranges would be as far out with a probability below kByChance; there are fewer than 60 checks, each with two
// sides, so that all of them together fail by chance in less than one run of 10,000.
#include <gtest/gtest.h>

#include <boost/math/distributions/binomial.hpp>

#include "bench/case_view_errors.h"
#include "bench/study_coverage.h"

namespace ocelli::test {
namespace {

constexpr double kByChance = 1e-6;

void expectShareIn(const Share& share, double least, double most, const std::string& what) {
  using boost::math::binomial;
  ASSERT_GT(share.trials, 0) << what;
  const double successes = share.successes;
  const double atMost = cdf(binomial(share.trials, least), successes);
  const double atLeast = successes == 0 ? 1 : cdf(complement(binomial(share.trials, most), successes - 1));
  EXPECT_GE(atMost, kByChance) << what << ": " << share.successes << " of " << share.trials << ", for " << least;
  EXPECT_GE(atLeast, kByChance) << what << ": " << share.successes << " of " << share.trials << ", for " << most;
}

CoverageResult coverageOf(const std::string& name, bool null, int studies) {
  static const Protocol protocol = readProtocol(OCELLI_ROSEN2010);
  for (const CoverageScenario& scenario : coverageScenarios()) {
    if (scenario.name == name) {
      const SimulatedStudy study = studyOf(scenario, protocol, null);
      return ocelli::coverageOf(modelOf(scenario), study, reportedTruths(scenario, study), {studies, null ? 12u : 11u});
    }
  }
  ADD_FAILURE() << "there is no scenario " << name;
  return {};
}

/// Coverage over studies with effects and as many without. `only`: a term; empty: all.
void expectNominal(const std::string& scenario, int studies, const std::string& only = "") {
  const CoverageResult effects = coverageOf(scenario, false, studies);
  const CoverageResult null = coverageOf(scenario, true, studies);
  EXPECT_LE(effects.impossible + effects.unconverged, studies / 100) << scenario;
  EXPECT_LE(null.impossible + null.unconverged, studies / 100) << scenario;
  ASSERT_FALSE(effects.terms.empty()) << scenario;
  ASSERT_EQ(effects.terms.size(), null.terms.size()) << scenario;
  for (size_t i = 0; i < effects.terms.size(); ++i) {
    const TermCoverage& term = effects.terms[i];
    ASSERT_EQ(term.name, null.terms[i].name);
    if (only.empty() || only == term.name) {
      const Share& other = null.terms[i].covered;
      const std::string what = scenario + ", " + term.name;
      expectShareIn({term.covered.successes + other.successes, term.covered.trials + other.trials}, 0.93, 0.97, what);
      expectShareIn(null.terms[i].rejected, 0.035, 0.065, what + ", true null rejected");
    }
  }
}

TEST(ReportCoverage, ofTimesToFind) {
  expectNominal("find-time", 400);
}

// Few, as each takes its time: the code is that of paths.
TEST(ReportCoverage, ofRightCounts) {
  expectNominal("count", 20);
}

TEST(ReportCoverage, ofRightPaths) {
  expectNominal("path", 600);
}

TEST(ReportCoverage, ofSurvivalWhereCasesDiffer) {
  expectNominal("find-log-normal", 500);
}

TEST(ReportCoverage, ofMatchedScenes) {
  expectNominal("count-matched", 500, "subjects, cases");
}

/// At the edge of what is equivalent: one of 20 may be taken for it.
TEST(ReportCoverage, ofEquivalenceAtItsBound) {
  const CoverageResult result = coverageOf("path-equivalence", false, 2000);
  for (const TermCoverage& term : result.terms) {
    if (term.name == "subjects, cases") {
      expectShareIn(term.rejected, 0, 0.065, "equivalence at its bound");
    }
  }
}

/// True nulls are rejected in 3 to 7 % where cases differ in the effect of the view: 8 subjects and 12 cases, or 20
/// scenes.
void expectErrorsIn(const std::string& model, double ofItemViews, int studies) {
  static const Protocol protocol = readProtocol(OCELLI_ROSEN2010);
  const ErrorRates rates = errorRatesOf({model, smallDesign(), ofItemViews}, protocol, {studies, 13});
  const std::string what = model + ", cases differ by " + std::to_string(ofItemViews);
  EXPECT_LE(rates.impossible, studies / 100) << what;
  expectShareIn(rates.rejected, 0.03, 0.07, what);
}

TEST(ReportCoverage, ofSearchesWhereCasesDifferInTheEffectOfTheView) {
  expectErrorsIn("find-time", 0.4, 400);
  expectErrorsIn("find-time", 0.8, 200);
}

TEST(ReportCoverage, ofSurvivalWhereCasesDifferInTheEffectOfTheView) {
  for (const char* model : {"find-hazard", "find-log-normal", "find-survival"}) {
    expectErrorsIn(model, 0.4, 2000);
  }
}

/// With 8 subjects and 10 paths nothing can be called equivalent; the one-sided test is as exact as it is with more.
TEST(ReportCoverage, ofEquivalenceWhereCasesDifferInTheEffectOfTheView) {
  static const Protocol protocol = readProtocol(OCELLI_ROSEN2010);
  for (const ErrorDesign& design : {smallDesign(), designOf2010()}) {
    const ErrorRates rates = errorRatesOf({"path-equivalence", design, 0.4}, protocol, {1000, 13});
    expectShareIn(rates.oneSided, 0.03, 0.07, design.name + ", one-sided");
    expectShareIn(rates.rejected, 0, 0.07, design.name + ", called equivalent");
  }
}

/// The same for a seed.
TEST(ReportCoverage, drawsTheSameStudiesAgain) {
  const CoverageResult first = coverageOf("path-equivalence", false, 20);
  const CoverageResult second = coverageOf("path-equivalence", false, 20);
  ASSERT_EQ(first.terms.size(), second.terms.size());
  for (size_t i = 0; i < first.terms.size(); ++i) {
    EXPECT_EQ(first.terms[i].meanError, second.terms[i].meanError);
  }
}

}  // namespace
}  // namespace ocelli::test
