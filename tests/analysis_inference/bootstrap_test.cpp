#include "analysis/inference/bootstrap.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <set>

#include "analysis/inference/restricted_mean.h"
#include "analysis/inference/restricted_mean_bootstrap.h"
#include "oc_core/base/error.h"
#include "oc_core/base/random_numbers.h"
#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

struct Study {
  std::vector<int> subjects;
  std::vector<int> cases;
  std::vector<double> values;

  BootstrapStatistic mean() const {
    return [this](const std::vector<ResampledRow>& rows) -> std::optional<double> {
      double sum = 0;
      for (const ResampledRow& row : rows) {
        sum += values[row.row];
      }
      return rows.empty() ? std::nullopt : std::optional(sum / static_cast<double>(rows.size()));
    };
  }
};

Study studyOf(int subjects, int cases, uint64_t seed) {
  RandomNumbers random(seed);
  Study study;
  std::vector<double> caseEffects;
  for (int j = 0; j < cases; ++j) {
    caseEffects.push_back(random.normal());
  }
  for (int i = 0; i < subjects; ++i) {
    const double subjectEffect = random.normal();
    for (int j = 0; j < cases; ++j) {
      study.subjects.push_back(100 + i);
      study.cases.push_back(7 * j);
      study.values.push_back(subjectEffect + caseEffects[static_cast<size_t>(j)] + random.normal());
    }
  }
  return study;
}

/// Variance of the mean of the means, drawn with replacement: over n, not n - 1.
double drawnVariance(const Study& study, const std::vector<int>& labels, int count) {
  double grand = 0, squares = 0;
  std::vector<double> sums(1000);
  for (size_t i = 0; i < labels.size(); ++i) {
    sums[static_cast<size_t>(labels[i])] += study.values[i];
    grand += study.values[i] / static_cast<double>(labels.size());
  }
  for (const double sum : sums) {
    const double mean = sum * count / static_cast<double>(labels.size());
    squares += sum == 0 ? 0 : (mean - grand) * (mean - grand);
  }
  return squares / count / count;
}

BootstrapPlan planOf(ResampledUnits units, size_t resamples = 20000) {
  return {5, resamples, units, 0.95};
}

TEST(Bootstrap, OfSubjectsHasTheSpreadOfTheirMeans) {
  const Study study = studyOf(12, 5, 1);
  const BootstrapResult result = *bootstrap(study.subjects, {}, study.mean(), planOf(ResampledUnits::kSubjects));
  EXPECT_EQ(result.subjects, 12u);
  EXPECT_EQ(result.cases, 0u);
  EXPECT_EQ(result.notEstimable, 0);
  // 4.5 standard deviations of a standard deviation of 20000 values: 2.3 %.
  EXPECT_NEAR(result.percentile.standardError, std::sqrt(drawnVariance(study, study.subjects, 12)),
              0.023 * result.percentile.standardError);
  // Nearly normal: the interval is that of the standard error.
  EXPECT_NEAR(result.percentile.upper - result.percentile.lower, 3.92 * result.percentile.standardError,
              0.1 * result.percentile.standardError);
}

TEST(Bootstrap, OfSubjectsAndCasesHasTheSpreadOfOwen) {
  // Exact for the mean of a complete design: the weights of a trial are the product of two independent counts.
  const int subjects = 10, cases = 6;
  const Study study = studyOf(subjects, cases, 2);
  const BootstrapResult result =
      *bootstrap(study.subjects, study.cases, study.mean(), planOf(ResampledUnits::kSubjectsAndCases));
  double grand = 0;
  for (const double value : study.values) {
    grand += value / (subjects * cases);
  }
  double ofSubjects = drawnVariance(study, study.subjects, subjects);
  double ofCases = drawnVariance(study, study.cases, cases);
  double squares = 0;
  for (const double value : study.values) {
    squares += (value - grand) * (value - grand);
  }
  // Var = A (1 - 1/c) + B (1 - 1/s) + E, of independent multinomial counts.
  const double expected = ofSubjects * (1 - 1.0 / cases) + ofCases * (1 - 1.0 / subjects) +
                          squares / (static_cast<double>(subjects * cases) * subjects * cases);
  EXPECT_NEAR(result.percentile.standardError, std::sqrt(expected), 0.023 * std::sqrt(expected));
  EXPECT_EQ(result.cases, 6u);
}

TEST(Bootstrap, GivesEachCopyANumberOfItsOwn) {
  const Study study = studyOf(4, 3, 3);
  const auto check = [&](const std::vector<ResampledRow>& rows) -> std::optional<double> {
    std::set<std::pair<int, int>> places;
    for (const ResampledRow& row : rows) {
      EXPECT_TRUE(places.emplace(row.subject, row.caseIndex).second);
      EXPECT_GE(row.subject, 0);
      EXPECT_LT(row.subject, 4);
      EXPECT_GE(row.caseIndex, 0);
      EXPECT_LT(row.caseIndex, 3);
    }
    return static_cast<double>(rows.front().row);
  };
  EXPECT_TRUE(bootstrap(study.subjects, study.cases, check, planOf(ResampledUnits::kSubjectsAndCases, 200)));
}

TEST(Bootstrap, IsTheSameWithAnyNumberOfThreads) {
  const Study study = studyOf(8, 4, 4);
  const auto run = [&](size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return *bootstrap(study.subjects, study.cases, study.mean(), planOf(ResampledUnits::kSubjectsAndCases, 3000));
  };
  const BootstrapResult one = run(1);
  const BootstrapResult four = run(4);
  EXPECT_EQ(one.percentile.lower, four.percentile.lower);
  EXPECT_EQ(one.percentile.upper, four.percentile.upper);
  EXPECT_EQ(one.percentile.standardError, four.percentile.standardError);
  EXPECT_EQ(one.bca->lower, four.bca->lower);
}

TEST(Bootstrap, HasTheBcaIntervalOfItsFormulas) {
  const Estimate interval = *bcaInterval(golden("bca/values"), 2.8, golden("bca/influences"), 0.95);
  expectGolden({interval.lower, interval.upper}, "bca/interval", kClosedForm);
}

TEST(Bootstrap, LeavesOutAndReportsWhatCannotBeEstimated) {
  const Study study = studyOf(6, 4, 5);
  // Needs the first subject: of 6, it is not drawn in (5/6)^6 = 33.5 % of the resamples.
  const auto statistic = [&](const std::vector<ResampledRow>& rows) -> std::optional<double> {
    const bool there = std::any_of(rows.begin(), rows.end(), [](const ResampledRow& row) { return row.row < 4; });
    return there ? study.mean()(rows) : std::nullopt;
  };
  const BootstrapResult result = *bootstrap(study.subjects, {}, statistic, planOf(ResampledUnits::kSubjects));
  EXPECT_NEAR(result.notEstimable, std::pow(5.0 / 6, 6), 0.015);  // 4.5 standard deviations
  EXPECT_EQ(result.bca.reason(), "without one of the subjects or cases the data do not give the statistic");
}

TEST(Bootstrap, SaysWhatItLacks) {
  const Study study = studyOf(3, 2, 6);
  const BootstrapPlan bySubject = planOf(ResampledUnits::kSubjects, 200);
  const BootstrapPlan both = planOf(ResampledUnits::kSubjectsAndCases, 200);
  const auto none = [](const std::vector<ResampledRow>&) { return std::optional<double>(); };
  const auto constant = [](const std::vector<ResampledRow>&) { return std::optional<double>(2); };
  const auto infinite = [](const std::vector<ResampledRow>&) { return std::optional<double>(INFINITY); };
  EXPECT_EQ(bootstrap({1, 1}, {}, constant, bySubject).reason(), "there is only one subject to draw from");
  EXPECT_EQ(bootstrap({1, 2}, {3, 3}, constant, both).reason(), "there is only one case to draw from");
  EXPECT_EQ(bootstrap(study.subjects, study.cases, none, both).reason(), "the data do not give the statistic");
  EXPECT_EQ(bootstrap(study.subjects, study.cases, infinite, both).reason(), "the data do not give the statistic");
  EXPECT_EQ(bootstrap(study.subjects, study.cases, constant, both).reason(), "all resamples give the same");
  EXPECT_THROW(bootstrap(study.subjects, {}, constant, both), InputError);
  EXPECT_THROW(bootstrap(study.subjects, {}, constant, planOf(ResampledUnits::kSubjects, 10)), InputError);
}

TEST(Bootstrap, OfRestrictedMeansIsThatOfTheMeansThemselves) {
  // The slow reference: the drawn trials, written out.
  std::vector<SurvivalTime> times = goldenTimes("find");
  for (size_t i = 0; i < times.size(); i += 9) {
    times[i].observed = false;  // censored before the horizon
  }
  std::vector<bool> views;
  for (const double view : golden("find/view")) {
    views.push_back(view == 1);
  }
  const auto statistic = [&](const std::vector<ResampledRow>& rows) -> std::optional<double> {
    std::vector<SurvivalTime> drawnTimes;
    std::vector<bool> drawnViews;
    for (const ResampledRow& row : rows) {
      drawnTimes.push_back(times[row.row]);
      drawnViews.push_back(views[row.row]);
    }
    const auto difference = restrictedMeanDifference(drawnTimes, drawnViews, 60);
    return difference ? std::optional(difference->difference.value) : std::nullopt;
  };
  const BootstrapPlan plan = planOf(ResampledUnits::kSubjectsAndCases, 300);
  const std::vector<int> subjects = goldenClusters("find");
  const std::vector<int> cases = goldenLabels("find/case");
  const BootstrapResult slow = *bootstrap(subjects, cases, statistic, plan);
  const BootstrapResult fast = *bootstrapRestrictedMeanDifference(times, views, 60, subjects, cases, plan);
  EXPECT_NEAR(fast.percentile.value, slow.percentile.value, 1e-10);
  EXPECT_NEAR(fast.percentile.lower, slow.percentile.lower, 1e-10);
  EXPECT_NEAR(fast.bca->upper, slow.bca->upper, 1e-10);
  EXPECT_GT(slow.notEstimable, 0);  // no time-out is drawn, and the last trial is censored
  EXPECT_EQ(fast.notEstimable, slow.notEstimable);
}

TEST(Bootstrap, OfRestrictedMeansAgreesWithTheirClusteredError) {
  std::vector<bool> views;
  for (const double view : golden("find/view")) {
    views.push_back(view == 1);
  }
  const std::vector<int> subjects = goldenClusters("find");
  const BootstrapResult bySubject = *bootstrapRestrictedMeanDifference(goldenTimes("find"), views, 60, subjects, {},
                                                                       planOf(ResampledUnits::kSubjects, 4000));
  EXPECT_NEAR(bySubject.percentile.value, golden("rmean/clustered")[0], 1e-10);
  // Without the factor 20 / 19, which drawing does not have; 4.5 standard deviations are 5 %.
  const double error = golden("rmean/clustered")[1] * std::sqrt(19.0 / 20);
  EXPECT_NEAR(bySubject.percentile.standardError, error, 0.05 * error);
  const BootstrapResult both =
      *bootstrapRestrictedMeanDifference(goldenTimes("find"), views, 60, subjects, goldenLabels("find/case"),
                                         planOf(ResampledUnits::kSubjectsAndCases, 1000));
  EXPECT_GT(both.percentile.standardError, bySubject.percentile.standardError);
}

}  // namespace
}  // namespace ocelli::test
