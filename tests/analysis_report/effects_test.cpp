// Effects beside the models, of trials whose answers are worked out by hand.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/report/count_conditions.h"
#include "analysis/report/effect_sizes.h"
#include "analysis/report/resampled_effects.h"
#include "oc_core/base/parallel.h"
#include "tests/analysis_report/hand_made_trials.h"

namespace ocelli {
namespace {

using test::findCell;
using test::findTable;
using test::HandMadeTrials;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

using test::kGc;
using test::kPpc;

/// Each of `subjects` sees 4 cases in both views; values vary by all of these.
HandMadeTrials crossed(int subjects) {
  HandMadeTrials trials("find");
  for (int subject = 0; subject < subjects; ++subject) {
    for (int i = 0; i < 8; ++i) {
      trials.add({.subject = fmt::format("S{}", subject),
                  .planIndex = i,
                  .caseIndex = i / 2,
                  .view = i % 2 == 0 ? kPpc : kGc,
                  .seconds = 4.0 + subject % 3 + i / 2 - (i % 2) * (1 + subject % 2)});
    }
  }
  return trials;
}

std::vector<double> secondsOf(const TrialList& trials) {
  std::vector<double> seconds;
  for (const Trial* trial : trials) {
    seconds.push_back(*trial->responseSeconds);
  }
  return seconds;
}

TEST(ResampledEffects, areDifferencesOfMeansWithIntervalsThatThreadsDoNotChange) {
  const HandMadeTrials trials = crossed(10);
  const std::vector<double> seconds = secondsOf(trials.list());
  const BootstrapPlan plan{7, 500};
  const auto once = bootstrapViewDifference(trials.list(), seconds, plan);
  ASSERT_TRUE(once.isPossible());
  // gc is 1 s faster for even subjects and 2 s for odd ones.
  EXPECT_NEAR(once->percentile.value, -1.5, 1e-12);
  EXPECT_EQ(once->subjects, 10u);
  EXPECT_EQ(once->cases, 4u);
  EXPECT_LT(once->percentile.lower, -1.5);
  EXPECT_GT(once->percentile.upper, -1.5);
  setThreadCount(1);
  const auto again = bootstrapViewDifference(trials.list(), seconds, plan);
  setThreadCount(0);
  EXPECT_EQ(once->percentile.standardError, again->percentile.standardError);
  EXPECT_EQ(once->percentile.lower, again->percentile.lower);
  EXPECT_EQ(once->percentile.upper, again->percentile.upper);
  const auto other = bootstrapViewDifference(trials.list(), seconds, {8, 500});
  EXPECT_NE(once->percentile.standardError, other->percentile.standardError);
}

TEST(ResampledEffects, weighMeansOfGroups) {
  const HandMadeTrials trials = crossed(9);
  // Twice the mean of cases 3 and 4 in ppc (5 + 2.5), less that of cases 1 and 2 (5 + 0.5); gc is in no group.
  std::vector<int> groups;
  for (const Trial* trial : trials.list()) {
    groups.push_back(trial->view == kGc ? -1 : trial->caseIndex / 2);
  }
  const auto sum = bootstrapContrast(trials.list(), secondsOf(trials.list()), groups, {-1, 2}, {1, 400});
  ASSERT_TRUE(sum.isPossible());
  EXPECT_NEAR(sum->percentile.value, 9.5, 1e-12);
  // One in 2^4 resamples of four cases lacks both of a group, for either group.
  EXPECT_NEAR(sum->notEstimable, 0.125, 4 * std::sqrt(0.125 * 0.875 / 400));
}

TEST(ResampledEffects, ofLogarithmsAreShownAsRatiosWithPlanSeedAndSamples) {
  const HandMadeTrials trials = crossed(6);
  std::vector<double> logs;
  double sum = 0;
  for (const Trial* trial : trials.list()) {
    logs.push_back(std::log(*trial->responseSeconds));
    sum += (trial->view == kGc ? 1 : -1) * logs.back();
  }
  AnalysisData analysis;
  analysis.plan.seed = 42;
  analysis.plan.bootstrapSamples = 300;
  ReportDocument document;
  document.origins.sources = {"study.db"};
  ReportWork work{analysis, document};
  addResampled(work, "Ratio", "ratio",
               {{"gc / ppc", bootstrapViewDifference(trials.list(), logs, bootstrapPlanOf(analysis.plan)),
                 trials.list(), "", true}});
  const ReportTable* table = findTable(document, "ratio");
  ASSERT_NE(table, nullptr);
  const ReportCell* cell = findCell(*table, "gc / ppc, percentiles", 1);
  EXPECT_NEAR(*cell->value, std::exp(sum / 24), 1e-12);
  EXPECT_THAT(cell->source, HasSubstr("300 resamples of 6 subjects and 4 cases, seed 42; 48 trials of 6 subjects"));
  EXPECT_THAT(test::notesOf(document), ElementsAre(HasSubstr("6 subjects and 4 cases are few")));
}

TEST(SubjectMeans, areOfSubjectsWithBothViews) {
  HandMadeTrials trials("find");
  trials.add({.subject = "B", .view = kPpc, .seconds = 4});
  trials.add({.subject = "B", .view = kPpc, .seconds = 8});
  trials.add({.subject = "B", .view = kGc, .seconds = 5});
  trials.add({.subject = "A", .view = kGc, .seconds = 1});
  const SubjectMeans means = subjectMeans(trials.list(), secondsOf(trials.list()));
  EXPECT_THAT(means.reference, ElementsAre(6));
  EXPECT_THAT(means.other, ElementsAre(5));
  EXPECT_THAT(means.differences, ElementsAre(-1));
}

TEST(EffectSizes, ofSharesAreThoseOfTheFourfoldTableAndOfSubjects) {
  HandMadeTrials trials;
  // ppc: 2, 1, 1 right of 4; gc: 4, 3, 2 right of 4.
  const int right[3][2] = {{2, 4}, {1, 3}, {1, 2}};
  for (int subject = 0; subject < 3; ++subject) {
    for (int view = 0; view < 2; ++view) {
      for (int i = 0; i < 4; ++i) {
        trials.add({.subject = fmt::format("S{}", subject),
                    .caseIndex = i,
                    .view = view == 0 ? kPpc : kGc,
                    .correct = i < right[subject][view]});
      }
    }
  }
  const AnalysisData analysis;
  ReportDocument document;
  document.origins.sources = {"study.db"};
  ReportWork work{analysis, document};
  addShareEffects(work, trials.list(), "sizes");
  const ReportTable* table = findTable(document, "sizes");
  ASSERT_NE(table, nullptr);
  EXPECT_NEAR(*findCell(*table, "Difference of shares", 1)->value, 9.0 / 12 - 4.0 / 12, 1e-12);
  EXPECT_NEAR(*findCell(*table, "Ratio of shares", 1)->value, 9.0 / 4, 1e-12);
  EXPECT_NEAR(*findCell(*table, "Odds ratio", 1)->value, (9.0 / 3) / (4.0 / 8), 1e-12);
  // Differences of shares: 1/2, 1/2, 1/4: mean 5/12, variance (2/144 + 4/144)/... = 1/48.
  EXPECT_NEAR(*findCell(*table, "d_z: over the spread of differences", 1)->value, 5.0 / 12 / std::sqrt(1.0 / 48),
              1e-12);
  EXPECT_NEAR(*findCell(*table, "Rank-biserial correlation of pairs", 1)->value, 1, 1e-12);
}

TEST(CountConditions, haveSharesOfEachConditionAndTheInteraction) {
  HandMadeTrials trials;
  // Right of 4 subjects x 3 cases in each condition: by view, seconds, duplicates.
  const int right[2][2][2] = {{{6, 3}, {9, 6}}, {{9, 9}, {12, 9}}};
  int caseIndex = 0;
  for (int view = 0; view < 2; ++view) {
    for (int seconds = 0; seconds < 2; ++seconds) {
      for (int duplicates = 0; duplicates < 2; ++duplicates, caseIndex += 3) {
        for (int i = 0; i < 12; ++i) {
          trials.add({.subject = fmt::format("S{}", i % 4),
                      .caseIndex = caseIndex + i / 4,
                      .view = view == 0 ? kPpc : kGc,
                      .correct = (i * 5) % 12 < right[view][seconds][duplicates],
                      .exposure = seconds == 0 ? 5 : 20,
                      .duplicates = duplicates == 1});
        }
      }
    }
  }
  AnalysisData analysis;
  analysis.plan.bootstrapSamples = 400;
  ReportDocument document;
  document.origins.sources = {"study.db"};
  ReportWork work{analysis, document};
  addCountConditions(work, trials.list());
  const ReportTable* shares = findTable(document, "count-conditions");
  ASSERT_NE(shares, nullptr);
  EXPECT_EQ(findCell(*shares, "5 s, colours shared, ppc", 1)->value, 0.25);
  EXPECT_EQ(findCell(*shares, "20 s, colours different, gc", 1)->value, 1);
  const ReportTable* differences = findTable(document, "count-differences");
  ASSERT_NE(differences, nullptr);
  EXPECT_NEAR(*findCell(*differences, "5 s, colours shared, percentiles", 1)->value, 0.5, 1e-12);
  // Shared: 1/2 and 1/4; different: 1/4 and 1/4. Of 20 s: 1/4 and 1/4; of 5 s: 1/2 and 1/4.
  EXPECT_NEAR(*findCell(*differences, "Interaction: shared less different colours, percentiles", 1)->value, 0.125,
              1e-12);
  EXPECT_NEAR(*findCell(*differences, "Interaction: 20 s less 5 s, percentiles", 1)->value, -0.125, 1e-12);
}

TEST(CountConditions, areNotThereWhereNoTrialSaysThem) {
  HandMadeTrials trials;
  trials.add({});
  const AnalysisData analysis;
  ReportDocument document;
  ReportWork work{analysis, document};
  addCountConditions(work, trials.list());
  EXPECT_THAT(test::notesOf(document), Contains(HasSubstr("no trial says")));
}

}  // namespace
}  // namespace ocelli
