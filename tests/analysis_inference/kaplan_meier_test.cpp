#include "analysis/inference/kaplan_meier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "analysis/base/distributions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/random_numbers.h"
#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

std::vector<double> column(const SurvivalCurve& curve, double (*value)(const SurvivalStep&)) {
  std::vector<double> values;
  for (const SurvivalStep& step : curve.steps) {
    values.push_back(value(step));
  }
  return values;
}

std::vector<double> medianOf(const std::vector<SurvivalTime>& times) {
  const Estimate median = *medianTime(*survivalCurve(times));
  return {median.value, median.lower, median.upper};
}

TEST(KaplanMeier, IsTheCurveOfSurvfitOnLung) {
  const SurvivalCurve curve = *survivalCurve(goldenTimes("lung"));
  const auto expect = [&](double (*value)(const SurvivalStep&), const char* name) {
    expectGolden(column(curve, value), name, kClosedForm);
  };
  expect([](const SurvivalStep& step) { return step.riskSet.seconds; }, "curve/time");
  expect([](const SurvivalStep& step) { return static_cast<double>(step.riskSet.atRisk); }, "curve/risk");
  expect([](const SurvivalStep& step) { return static_cast<double>(step.riskSet.events); }, "curve/events");
  expect([](const SurvivalStep& step) { return step.survival; }, "curve/survival");
  expect([](const SurvivalStep& step) { return step.standardError; }, "curve/error");
  expect([](const SurvivalStep& step) { return step.lower; }, "curve/lower");
  expect([](const SurvivalStep& step) { return step.upper; }, "curve/upper");
}

TEST(KaplanMeier, HasTheMediansOfSurvfit) {
  expectGolden(medianOf(goldenTimes("lung")), "median/lung", kClosedForm);
  std::vector<SurvivalTime> flat;
  for (const double seconds : {1, 2, 3, 4, 5, 6, 10, 11, 12, 13, 14, 15}) {
    flat.push_back({seconds, seconds < 15});
  }
  expectGolden(medianOf(flat), "median/flat", kClosedForm);
  const std::vector<SurvivalTime> few = {{1, true}, {2, true},  {3, false}, {4, true},
                                         {5, true}, {6, false}, {7, false}, {8, false}};
  expectGolden(medianOf(few), "median/few", kClosedForm);
  EXPECT_TRUE(std::isinf(medianTime(*survivalCurve(few))->upper));
}

TEST(KaplanMeier, WithoutCensoringCountsWhoIsLeft) {
  const SurvivalCurve curve = *survivalCurve({{3, true}, {1, true}, {2, true}, {2, true}});
  ASSERT_EQ(curve.steps.size(), 3u);
  EXPECT_DOUBLE_EQ(curve.steps[0].survival, 0.75);
  EXPECT_DOUBLE_EQ(curve.steps[1].survival, 0.25);
  EXPECT_DOUBLE_EQ(curve.steps[2].survival, 0);
  EXPECT_TRUE(std::isnan(curve.steps[2].standardError));
}

/// Trials of subjects and cases that differ; each subject has each case once.
struct ClusteredTrials {
  std::vector<SurvivalTime> times;
  std::vector<int> subjects;
  std::vector<int> cases;
};

struct CurveSpread {
  double ofSubjects = 0, ofCases = 0, ofTrials = 0;  // log seconds
};

constexpr double kTrueMedian = 20;

ClusteredTrials clusteredTrials(int subjects, int cases, const CurveSpread& spread, RandomNumbers& random) {
  std::vector<double> ofCases(static_cast<size_t>(cases));
  for (double& value : ofCases) {
    value = spread.ofCases * random.normal();
  }
  ClusteredTrials trials;
  for (int subject = 0; subject < subjects; ++subject) {
    const double ofSubject = spread.ofSubjects * random.normal();
    for (int each = 0; each < cases; ++each) {
      const double seconds =
          kTrueMedian * std::exp(ofSubject + ofCases[static_cast<size_t>(each)] + spread.ofTrials * random.normal());
      trials.times.push_back({std::min(seconds, 60.0), seconds < 60});
      trials.subjects.push_back(subject);
      trials.cases.push_back(each);
    }
  }
  return trials;
}

TEST(KaplanMeier, HasTheClusteredErrorsOfSurvfit) {
  std::vector<double> errors;
  const std::vector<int> clusters = goldenClusters("find");
  const SurvivalCurve curve = *survivalCurve(goldenTimes("find"), 0.95, clusters);
  for (const SurvivalStep& step : curve.steps) {
    errors.push_back(step.standardError / std::sqrt(20.0 / 19));  // survfit has no factor for few clusters
  }
  expectGolden(errors, "curve/clustered_error", kClosedForm);
}

/// log S(t) where the trials that `weightOf` tells weigh otherwise: the slow way.
double weighedLogSurvival(const std::vector<SurvivalTime>& times, double seconds,
                          const std::function<double(size_t)>& weightOf) {
  double logSurvival = 0;
  for (const RiskSet& set : riskSets(times)) {
    double atRisk = 0, events = 0;
    for (size_t i = 0; i < times.size() && set.seconds <= seconds; ++i) {
      atRisk += times[i].seconds >= set.seconds ? weightOf(i) : 0;
      events += times[i].seconds == set.seconds && times[i].observed ? weightOf(i) : 0;
    }
    logSurvival += events > 0 ? std::log(1 - events / atRisk) : 0;
  }
  return logSurvival;
}

TEST(KaplanMeier, HasTheErrorsOfWeighingSubjectsAndCases) {
  RandomNumbers random(8);
  const ClusteredTrials trials = clusteredTrials(7, 9, {0.4, 0.5, 0.5}, random);
  const SurvivalCurve curve = *survivalCurve(trials.times, 0.95, trials.subjects, trials.cases);
  constexpr double kStep = 1e-5;
  for (const size_t k : {size_t{5}, size_t{20}, size_t{40}}) {
    const SurvivalStep& step = curve.steps[k];
    // By how much log S changes with the weight of all trials of a subject, of a case, of both.
    const auto squares = [&](const std::function<int(size_t)>& labelOf, int labels) {
      double sum = 0;
      for (int label = 0; label < labels; ++label) {
        const auto with = [&](double weight) {
          return weighedLogSurvival(trials.times, step.riskSet.seconds,
                                    [&](size_t i) { return labelOf(i) == label ? weight : 1.0; });
        };
        const double slope = (with(1 + kStep) - with(1 - kStep)) / (2 * kStep);
        sum += slope * slope;
      }
      return sum;
    };
    const double bySubject = squares([&](size_t i) { return trials.subjects[i]; }, 7) * 7 / 6;
    const double byCase = squares([&](size_t i) { return trials.cases[i]; }, 9) * 9 / 8;
    const double byBoth = squares([&](size_t i) { return static_cast<int>(i); }, 63);
    const double error = std::sqrt(bySubject + std::max(0.0, byCase - byBoth));
    EXPECT_NEAR(step.standardError, step.survival * error, 1e-7);  // of the differences
    const double center = std::log(-std::log(step.survival));
    const double width = studentQuantile(0.975, 6) * error / -std::log(step.survival);
    EXPECT_NEAR(step.lower, std::exp(-std::exp(center + width)), 1e-6);
    EXPECT_NEAR(step.upper, std::exp(-std::exp(center - width)), 1e-6);
  }
}

TEST(KaplanMeier, BandsOfTrialsThatAreAlikeAreWider) {
  RandomNumbers random(3);
  const ClusteredTrials trials = clusteredTrials(10, 12, {0.7, 0.7, 0.2}, random);
  const SurvivalCurve naive = *survivalCurve(trials.times);
  const SurvivalCurve clustered = *survivalCurve(trials.times, 0.95, trials.subjects, trials.cases);
  const SurvivalStep& naiveMiddle = naive.steps[naive.steps.size() / 2];
  const SurvivalStep& middle = clustered.steps[clustered.steps.size() / 2];
  EXPECT_EQ(middle.survival, naiveMiddle.survival);
  EXPECT_GT(middle.upper - middle.lower, 2 * (naiveMiddle.upper - naiveMiddle.lower));
  const Estimate naiveMedian = *medianTime(naive);
  const Estimate median = *medianTime(clustered);
  EXPECT_EQ(median.value, naiveMedian.value);
  EXPECT_LT(median.lower, naiveMedian.lower - 2);
  EXPECT_GT(median.upper, naiveMedian.upper + 2);
}

// 300 studies: three standard errors of a share of 95 % are 3.8 %.
TEST(KaplanMeier, IntervalsOfTheMedianHoldItWhereSubjectsAndCasesDiffer) {
  constexpr int kStudies = 300;
  int naive = 0;
  int clustered = 0;
  for (int study = 0; study < kStudies; ++study) {
    RandomNumbers random(5, static_cast<uint64_t>(study));
    const ClusteredTrials trials = clusteredTrials(8, 10, {0.4, 0.4, 0.4}, random);
    const auto holds = [](const Estimate& median) {
      return median.lower <= kTrueMedian && kTrueMedian <= median.upper;
    };
    naive += holds(*medianTime(*survivalCurve(trials.times))) ? 1 : 0;
    clustered += holds(*medianTime(*survivalCurve(trials.times, 0.95, trials.subjects, trials.cases))) ? 1 : 0;
  }
  EXPECT_LT(naive, 0.75 * kStudies);
  EXPECT_GT(clustered, 0.91 * kStudies) << "of " << kStudies;
}

TEST(KaplanMeier, OfOneSubjectOrCaseIsACurveWithoutBands) {
  const std::vector<SurvivalTime> times = {{10, true}, {20, true}, {30, true}, {40, true}};
  const SurvivalCurve ofOneSubject = *survivalCurve(times, 0.95, {1, 1, 1, 1}, {1, 2, 3, 4});
  EXPECT_EQ(ofOneSubject.noBands, "all trials belong to one subject, so subjects cannot be compared");
  EXPECT_EQ(ofOneSubject.steps[0].survival, 0.75);
  EXPECT_TRUE(std::isnan(ofOneSubject.steps[0].lower));
  const Estimate median = *medianTime(ofOneSubject);
  EXPECT_EQ(median.value, 25);
  EXPECT_TRUE(std::isnan(median.upper)) << "not known is not infinite";
  EXPECT_EQ(survivalCurve(times, 0.95, {1, 2, 1, 2}, {7, 7, 7, 7})->noBands,
            "all trials are of one case, so cases cannot be compared");
  EXPECT_THROW(survivalCurve(times, 0.95, {1, 2}), InputError);
}

TEST(KaplanMeier, SubjectsWhoseTimesAreTheSameGiveNoBandOfWidthNought) {
  const SurvivalCurve curve = *survivalCurve({{10, true}, {20, true}, {10, true}, {20, true}}, 0.95, {1, 1, 2, 2});
  EXPECT_TRUE(std::isnan(curve.steps[0].lower));
  EXPECT_TRUE(std::isnan(curve.steps[0].standardError));
}

TEST(KaplanMeier, SaysWhyThereIsNoMedian) {
  EXPECT_EQ(survivalCurve({}).reason(), "there are no trials");
  const SurvivalCurve timeOuts = *survivalCurve({{60, false}, {60, false}, {20, true}});
  EXPECT_EQ(medianTime(timeOuts).reason(), "only 1 of 3 trials ended, so the curve never falls to a half");
}

}  // namespace
}  // namespace ocelli::test
