// n-down-1-up: its steps by hand, and where it settles.
#include "study/protocol/up_down.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/random.h"
#include "study/agent/chance.h"
#include "study/protocol/psychometric_function.h"

namespace ocelli {
namespace {

std::vector<double> steps(int count, double factor) {
  std::vector<double> levels;
  for (int i = 0; i < count; ++i) {
    levels.push_back(0.01 * std::pow(factor, i));
  }
  return levels;
}

/// Answers what is to be answered, in order, at the levels that the staircase asks for.
std::vector<size_t> levelsOf(const UpDown& staircase, const std::vector<bool>& correct,
                             std::vector<LevelAnswer>& answers) {
  std::vector<size_t> shown;
  for (const bool each : correct) {
    shown.push_back(staircase.next(answers));
    answers.push_back({shown.back(), each});
  }
  return shown;
}

TEST(UpDown, GoesDownAfterThreeRightAndUpAfterOneWrong) {
  const UpDown staircase(steps(10, 1.5), {.rightInARow = 3, .firstStep = 2});
  std::vector<LevelAnswer> answers;
  EXPECT_EQ(
      levelsOf(staircase,
               {true, true, true, true, true, true, false, true, false, true, true, true, true, true, true, false},
               answers),
      (std::vector<size_t>{9, 9, 9, 7, 7, 7, 5, 6, 6, 7, 7, 7, 6, 6, 6, 5}));
  EXPECT_EQ(staircase.next(answers), 6u);
  EXPECT_EQ(staircase.turns(answers), (std::vector<size_t>{5, 7, 5})) << "two right ones and a wrong one are no turn";
}

TEST(UpDown, StaysWithinTheLevels) {
  const UpDown staircase(steps(3, 2), {.rightInARow = 1, .firstStep = 5});
  std::vector<LevelAnswer> answers;
  EXPECT_EQ(levelsOf(staircase, {false, false, true, true, true}, answers), (std::vector<size_t>{2, 2, 2, 1, 0}));
  EXPECT_EQ(staircase.next(answers), 0u);
}

TEST(UpDown, TheThresholdIsTheGeometricMeanOfAnEvenNumberOfLaterTurns) {
  const UpDown staircase(steps(10, 2), {.rightInARow = 1, .firstStep = 1});
  std::vector<LevelAnswer> answers;
  levelsOf(staircase, {true, true, true, false, true}, answers);  // 9 8 7 6 7: turns at 6 and 7
  EXPECT_EQ(staircase.turns(answers), (std::vector<size_t>{6, 7}));
  EXPECT_FALSE(staircase.threshold(answers).has_value());
  levelsOf(staircase, {true, false, false, true}, answers);  // 6 5 6 7: turns at 5 and 7
  EXPECT_EQ(staircase.turns(answers), (std::vector<size_t>{6, 7, 5, 7}));
  EXPECT_NEAR(staircase.threshold(answers).value(), 0.01 * std::pow(2, 6), 1e-12);
  levelsOf(staircase, {true, false}, answers);  // 6 5: a turn at 5; of an odd number the first is left out
  EXPECT_EQ(staircase.turns(answers), (std::vector<size_t>{6, 7, 5, 7, 5}));
  EXPECT_NEAR(staircase.threshold(answers).value(), 0.01 * std::pow(2, 6), 1e-12);
}

// Levitt's table I: 0.707 of 2, 0.794 of 3, 0.841 of 4.
TEST(UpDown, SettlesWhereNRightAnswersInARowAreAsLikelyAsNot) {
  for (const auto& [n, target] : std::vector<std::pair<int, double>>{{1, 0.5}, {2, 0.707}, {3, 0.794}, {4, 0.841}}) {
    const UpDown staircase(steps(60, 1.1), {.rightInARow = n, .firstStep = 4});
    EXPECT_NEAR(staircase.target(), target, 5e-4);
    // Chances to be right from 0 to 1, so that each target is one.
    const PsychometricFunction subject{&psychometricShapes()[1], std::log(0.1), 2, 0, 0};
    constexpr int kRuns = 20;
    constexpr int kTrials = 1500;
    double sum = 0;
    double logs = 0;
    Random random(static_cast<uint64_t>(n));
    for (int run = 0; run < kRuns; ++run) {
      std::vector<LevelAnswer> answers;
      for (int i = 0; i < kTrials; ++i) {
        const size_t level = staircase.next(answers);
        answers.push_back({level, happens(random, subject.right(std::log(steps(60, 1.1)[level])))});
      }
      logs += std::log(staircase.threshold(answers).value()) / kRuns;
      int right = 0;
      for (size_t i = 300; i < answers.size(); ++i) {
        right += answers[i].correct ? 1 : 0;
      }
      sum += static_cast<double>(right) / (kTrials - 300) / kRuns;
    }
    // Of 24,000 answers, which follow each other: less than 0.001 was measured for the share of right ones, 0.006 for
    // the chance at the threshold, which the turns of a staircase of few levels a turn place a little above.
    EXPECT_NEAR(sum, target, 0.005) << n;
    EXPECT_NEAR(subject.right(logs), target, 0.015) << n;
  }
}

}  // namespace
}  // namespace ocelli
