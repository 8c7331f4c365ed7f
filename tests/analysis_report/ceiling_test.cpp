// A ceiling cannot be tested: where all subjects do the same in both views, what is left of their differences is
// rounding, which must not become an interval of 1e-16, a p value of 0 and "equivalent".
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/inference/bayes_factor.h"
#include "analysis/inference/effect_size.h"
#include "analysis/inference/wilcoxon.h"
#include "analysis/report/count_pairs.h"
#include "analysis/report/effect_sizes.h"
#include "analysis/report/methods_section.h"
#include "analysis/report/path_section.h"
#include "analysis/report/resampled_effects.h"
#include "analysis/report/right_answers.h"
#include "analysis/report/subject_means.h"
#include "tests/analysis_report/hand_made_trials.h"
#include "tests/analysis_report/section_study.h"

namespace ocelli::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Subjects see cases in both views, some of them more often; `rightOf` says how many of four trials are right.
HandMadeTrials alike(int subjects, int cases, const std::function<int(int subject)>& rightOf) {
  HandMadeTrials trials("path");
  for (int subject = 0; subject < subjects; ++subject) {
    for (int i = 0; i < cases; ++i) {
      for (const TrialView view : {TrialView::kReference, TrialView::kOther}) {
        // The same share of more trials: sums in another order.
        const int repeats = view == TrialView::kOther && subject % 2 == 0 ? 3 : 1;
        for (int k = 0; k < 4 * repeats; ++k) {
          trials.add({.subject = fmt::format("S{}", subject),
                      .caseIndex = i,
                      .view = view,
                      .correct = k / repeats < rightOf(subject),
                      .seconds = 7.3});
        }
      }
    }
  }
  return trials;
}

TEST(Ceiling, whereAllIsRightNoDifferenceIsTested) {
  for (int subjects = 2; subjects <= 13; ++subjects) {
    for (int cases = 2; cases <= 5; ++cases) {
      SCOPED_TRACE(fmt::format("{} subjects, {} cases", subjects, cases));
      for (const int right : {0, 4}) {
        const HandMadeTrials trials = alike(subjects, cases, [&](int) { return right; });
        EXPECT_FALSE(shareDifference(trials.list()));
        const Estimable<EquivalenceTest> equivalence = shareEquivalence(trials.list(), {-0.1, 0.1}, 0.05);
        ASSERT_FALSE(equivalence);
        EXPECT_THAT(equivalence.reason(), HasSubstr("all subjects and cases have the same difference"));
      }
    }
  }
}

TEST(Ceiling, whereTimesAreAlikeNoDifferenceIsTested) {
  for (int subjects = 2; subjects <= 13; ++subjects) {
    SCOPED_TRACE(subjects);
    const HandMadeTrials trials = alike(subjects, 3, [](int) { return 4; });
    std::vector<double> logs;
    TrialValues values;
    for (const Trial* trial : trials.list()) {
      logs.push_back(std::log(*trial->responseSeconds));
      values.push_back({trial, logs.back()});
    }
    EXPECT_FALSE(bootstrapViewDifference(trials.list(), logs, {1, 100}));
    const SubjectMeans means = subjectMeans(trials.list(), logs);
    EXPECT_FALSE(pairedEffect(means.reference, means.other));
    EXPECT_FALSE(signedRankTest(means.differences));
    EXPECT_FALSE(matchedRankBiserial(means.differences));
    EXPECT_FALSE(bayesFactorOfMean(means.differences));
    const ComparisonRow row = compareViews("Time", values, ValueScale::kLogarithm);
    EXPECT_TRUE(!row.difference.estimate || std::isnan(row.difference.estimate->pValue));
  }
}

/// Shares of 1/4, 2/4 and 3/4, the same in both views.
TEST(Ceiling, whereEachSubjectDoesTheSameInBothViewsNoDifferenceIsTested) {
  for (int subjects = 2; subjects <= 13; ++subjects) {
    SCOPED_TRACE(subjects);
    const HandMadeTrials trials = alike(subjects, 3, [](int subject) { return 1 + subject % 3; });
    const std::vector<double> differences = shareDifferences(trials.list());
    EXPECT_FALSE(bayesFactorOfMean(differences));
    EXPECT_FALSE(signedRankTest(differences));
    EXPECT_FALSE(shareDifference(trials.list()));
  }
}

TEST(Ceiling, aReportSaysThatItCannotBeTested) {
  SectionStudy study;
  for (int subject = 0; subject < 7; ++subject) {
    for (int i = 0; i < 6; ++i) {
      Trial& trial = study.add(fmt::format("S{}", subject), 1, i % 2 == 0 ? TrialView::kReference : TrialView::kOther,
                               3, true, "path");
      trial.caseIndex = i / 2;
    }
  }
  study.analysis.plan.bootstrapSamples = 100;
  const ReportDocument document = documentOf(study.analysis, [](ReportWork& work) {
    const ReportTask task = reportTask("path");
    task.parts.front().add(work, task);
    addHypotheses(work);
  });
  EXPECT_EQ(cellText(document, "path-equivalence", "Equivalent", "Value"), "no such cell");
  EXPECT_THAT(reasonsOf(document),
              Contains(HasSubstr("Equivalence of the views: all subjects and cases have the same")));
  EXPECT_THAT(reasonsOf(document), Contains(HasSubstr("Bayes factor: all")));
  EXPECT_THAT(cellText(document, "family-primary", "path-alike", "Result"), HasSubstr("cannot be tested"));
}

}  // namespace
}  // namespace ocelli::test
