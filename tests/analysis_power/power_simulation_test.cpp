#include "analysis/power/power_simulation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/report/report_task.h"
#include "analysis/report/view_test.h"
#include "oc_core/base/parallel.h"
#include "tests/analysis_power/small_protocol.h"
#include "tests/ranks/thread_ranks.h"

namespace ocelli {
namespace {

class PowerSimulation : public testing::Test {
 protected:
  void TearDown() override { setThreadCount(0); }

  PowerWork workOf(const std::string& task, std::vector<int> subjects, int simulations) const {
    PowerWork work{protocol_, plan_, *viewModelOf(plan_, task)};
    work.subjects = std::move(subjects);
    work.simulations = simulations;
    return work;
  }
  Truth truthOf(SupposedEffects supposed) const { return wantedTruth(protocol_, supposed); }
  Truth searches(double ratio) const {
    SupposedEffects supposed;
    supposed.task = "find";
    supposed.ratio = ratio;
    return truthOf(supposed);
  }
  Truth answers(const std::string& task, double ppc, double gc) const {
    SupposedEffects supposed;
    supposed.task = task;
    supposed.sharePpc = ppc;
    supposed.shareGc = gc;
    return truthOf(supposed);
  }

  Protocol protocol_ = test::smallProtocol();
  AnalysisPlan plan_ = defaultPlan();
};

double shareOf(const PowerSize& size) {
  return static_cast<double>(size.found.successes) / size.found.trials;
}

// The standard error of a share of 5 % of 1,000 studies is 0.7 %; three of them on either side.
constexpr int kManyStudies = 1000;
constexpr double kMinError = 0.029;
constexpr double kMaxError = 0.071;

TEST_F(PowerSimulation, WithoutAnEffectSearchesFindOneAsOftenAsAlphaSays) {
  const auto curves = simulatePower(workOf("find", {16}, kManyStudies), {searches(1)});
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0].question, PowerCurve::Question::kFalseAlarm);
  EXPECT_EQ(curves[0].sizes[0].notEstimable, 0);
  EXPECT_GT(shareOf(curves[0].sizes[0]), kMinError);
  EXPECT_LT(shareOf(curves[0].sizes[0]), kMaxError);
  EXPECT_NEAR(curves[0].sizes[0].estimate, 1, 0.01);
}

TEST_F(PowerSimulation, WithoutAnEffectCountsFindOneAsOftenAsAlphaSays) {
  const auto curves = simulatePower(workOf("count", {24}, kManyStudies), {answers("count", 0.6, 0.6)});
  EXPECT_GT(shareOf(curves[0].sizes[0]), kMinError);
  EXPECT_LT(shareOf(curves[0].sizes[0]), kMaxError);
}

/// Few subjects, nearly all right: some studies are at a ceiling, or have no error to test against.
TEST_F(PowerSimulation, StudiesThatCannotBeEstimatedHaveNoResultAndEndNothing) {
  const auto curves = simulatePower(workOf("count", {2, 3, 4}, 100), {answers("count", 0.97, 0.97)});
  ASSERT_EQ(curves.size(), 1U);
  int notEstimable = 0;
  for (const PowerSize& size : curves[0].sizes) {
    EXPECT_EQ(size.found.trials, 100);
    EXPECT_LE(size.found.successes, 100 - size.notEstimable) << "what has no result found nothing";
    EXPECT_EQ(size.reason.empty(), size.notEstimable == 0);
    EXPECT_EQ(size.reason.find("failed"), std::string::npos) << size.reason;
    notEstimable += size.notEstimable;
  }
  EXPECT_GT(notEstimable, 0);
}

TEST_F(PowerSimulation, PowerGrowsWithSubjectsAndTheEffect) {
  const auto curves = simulatePower(workOf("find", {6, 12, 24}, 200), {searches(0.8), searches(0.7)});
  ASSERT_EQ(curves.size(), 2U);
  for (const PowerCurve& curve : curves) {
    EXPECT_EQ(curve.question, PowerCurve::Question::kPower);
    EXPECT_LT(shareOf(curve.sizes[0]), shareOf(curve.sizes[1]));
    EXPECT_LT(shareOf(curve.sizes[1]), shareOf(curve.sizes[2]));
  }
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_LT(shareOf(curves[0].sizes[i]), shareOf(curves[1].sizes[i]));
  }
  EXPECT_NEAR(curves[0].sizes[2].estimate, 0.8, 0.02) << "the model finds the effect that was put in";
}

TEST_F(PowerSimulation, EquivalenceIsShownWhereThereIsSomeAndSeldomAtTheBound) {
  PowerWork work = workOf("path", {40, 100}, 150);
  work.bounds = equivalenceBoundsOf(plan_, "path");
  ASSERT_NE(work.bounds, nullptr);
  // So near to all right that the few cases of the protocol, which count as drawn too, leave differences small.
  const Truth alike = answers("path", 0.9, 0.9);
  const auto curves = simulatePower(work, {alike, *truthAtBound(protocol_, alike, *work.bounds)});
  ASSERT_EQ(curves.size(), 3U);
  EXPECT_EQ(curves[0].test, PowerCurve::Test::kView);
  EXPECT_EQ(curves[0].question, PowerCurve::Question::kFalseAlarm);
  EXPECT_EQ(curves[1].test, PowerCurve::Test::kEquivalence);
  EXPECT_EQ(curves[1].question, PowerCurve::Question::kPower);
  EXPECT_LT(shareOf(curves[1].sizes[0]), shareOf(curves[1].sizes[1]));
  EXPECT_GT(shareOf(curves[1].sizes[1]), 0.5);
  EXPECT_NEAR(curves[1].sizes[1].estimate, 0, 0.01);
  EXPECT_EQ(curves[2].question, PowerCurve::Question::kFalseAlarm);
  // 5 % at most, and three standard errors of 150 studies.
  EXPECT_LT(shareOf(curves[2].sizes[1]), 0.05 + 3 * 0.0178);
}

TEST_F(PowerSimulation, IsTheSameForAnyNumberOfThreadsAndOtherSizes) {
  const std::vector<Truth> truths{searches(0.7), searches(1)};
  setThreadCount(1);
  const auto alone = simulatePower(workOf("find", {4, 8}, 30), truths);
  setThreadCount(3);
  const auto together = simulatePower(workOf("find", {4, 6, 8}, 30), truths);
  for (size_t c = 0; c < truths.size(); ++c) {
    for (const size_t size : {0U, 1U}) {
      const PowerSize& one = alone[c].sizes[size];
      const PowerSize& other = together[c].sizes[2 * size];
      EXPECT_EQ(one.subjects, other.subjects);
      EXPECT_EQ(one.found.successes, other.found.successes);
      EXPECT_EQ(one.warned, other.warned);
      EXPECT_EQ(one.estimate, other.estimate);
    }
  }
}

TEST_F(PowerSimulation, StudiesWithoutAResultFindNothing) {
  // All answers are right.
  Truth truth = answers("count", 0.6, 0.6);
  truth.effects.at("count", "right") = 19;
  const auto curves = simulatePower(workOf("count", {5}, 20), {truth});
  EXPECT_EQ(curves[0].sizes[0].notEstimable, 20);
  EXPECT_EQ(curves[0].sizes[0].found.successes, 0);
  EXPECT_EQ(curves[0].sizes[0].found.trials, 20);
  EXPECT_FALSE(curves[0].sizes[0].reason.empty());
}

TEST_F(PowerSimulation, SubjectsDropOutAfterSessions) {
  Protocol protocol = protocol_;
  protocol.sessions = 3;
  EXPECT_EQ(sessionsOf(protocol, 4, 0, 1), (std::vector<int>{3, 3, 3, 3}));
  const std::vector<int> sessions = sessionsOf(protocol, 4000, 0.25, 1);
  const auto share = [&](int count) {
    return static_cast<double>(std::count(sessions.begin(), sessions.end(), count)) / 4000;
  };
  // Four standard errors of 0.007.
  EXPECT_NEAR(share(1), 0.25, 0.028);
  EXPECT_NEAR(share(2), 0.75 * 0.25, 0.028);
  EXPECT_NEAR(share(3), 0.75 * 0.75, 0.028);
}

TEST_F(PowerSimulation, IsTheSameForAnyNumberOfRanks) {
  const PowerWork work = workOf("find", {4, 8}, 20);
  const std::vector<Truth> truths{searches(0.8), searches(1)};
  const auto alone = simulatePower(work, truths);
  for (const int size : {2, 3}) {
    test::runInRanks(size, [&](Ranks& ranks) {
      const auto together = simulatePower(work, truths, ranks);
      ASSERT_EQ(together.size(), ranks.isFirst() ? alone.size() : 0);
      for (size_t curve = 0; curve < together.size(); ++curve) {
        for (size_t i = 0; i < alone[curve].sizes.size(); ++i) {
          EXPECT_EQ(together[curve].sizes[i].found.successes, alone[curve].sizes[i].found.successes);
          EXPECT_EQ(together[curve].sizes[i].estimate, alone[curve].sizes[i].estimate);
          EXPECT_EQ(together[curve].sizes[i].analysed, alone[curve].sizes[i].analysed);
        }
      }
    });
  }
}

}  // namespace
}  // namespace ocelli
