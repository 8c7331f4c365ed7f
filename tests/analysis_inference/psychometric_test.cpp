#include "analysis/inference/psychometric.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/random_numbers.h"

namespace ocelli::test {
namespace {

/// Answers to levels on a grid, as often each.
std::vector<LevelCounts> answersOf(RandomNumbers& numbers, const PsychometricModel& model,
                                   const PsychometricPoint& truth, int trialsOfLevel) {
  std::vector<LevelCounts> counts;
  for (double level = -2; level <= 2; level += 0.5) {
    LevelCounts each{level, 0, trialsOfLevel};
    for (int i = 0; i < trialsOfLevel; ++i) {
      each.right += numbers.uniform() < rightProbability(model, truth, level) ? 1 : 0;
    }
    counts.push_back(each);
  }
  return counts;
}

/// All of a fine grid: slow, and without any search.
PsychometricPoint bestOfGrid(const PsychometricModel& model, const std::vector<LevelCounts>& counts,
                             const PsychometricPoint& around, double reach, int steps) {
  PsychometricPoint best = around;
  double value = -INFINITY;
  for (int i = -steps; i <= steps; ++i) {
    for (int k = -steps; k <= steps; ++k) {
      for (int l = 0; l <= steps; ++l) {
        const PsychometricPoint point{around.logThreshold + reach * i / steps, around.logSlope + reach * k / steps,
                                      kMaxLapse * l / steps};
        if (const double there = logPosterior(model, counts, point); there > value) {
          value = there;
          best = point;
        }
      }
    }
  }
  return best;
}

TEST(Psychometric, ModeIsThatOfASlowGrid) {
  RandomNumbers numbers(3);
  for (const PsychometricShape& shape : psychometricShapes()) {
    for (const double guess : {0.0, 0.25, 0.5}) {
      PsychometricModel model;
      model.shape = &shape;
      model.guess = guess;
      const std::vector<LevelCounts> counts = answersOf(numbers, model, {0.3, std::log(3.0), 0.02}, 12);
      const Estimable<PsychometricFit> fit = fitPsychometric(model, counts);
      ASSERT_TRUE(fit) << shape.name << " " << guess;
      // A coarse grid over all that the priors allow, and a finer one around its best.
      const PsychometricPoint coarse = bestOfGrid(model, counts, {0, std::log(4.0), 0}, 4, 30);
      const PsychometricPoint fine = bestOfGrid(model, counts, coarse, 4.0 / 30, 30);
      EXPECT_GE(fit->logPosterior, logPosterior(model, counts, fine) - 1e-9) << "no point of the grid is better";
      // Within a step of the finer grid; where the posterior is that flat, of three.
      EXPECT_NEAR(fit->point.logThreshold, fine.logThreshold, 3 * 4.0 / 30 / 30) << shape.name << " " << guess;
      EXPECT_NEAR(fit->point.logSlope, fine.logSlope, 3 * 4.0 / 30 / 30) << shape.name << " " << guess;
      EXPECT_NEAR(fit->point.lapse, fine.lapse, 0.005) << shape.name << " " << guess;
    }
  }
}

/// Of 300 subjects with 60 trials: mean thresholds are off by less than 0.05 (a tenth of a step of levels), and their
/// spread is the standard error that the fit gives, within a fifth.
TEST(Psychometric, ThresholdsAreThoseThatAnswersWereDrawnWith) {
  RandomNumbers numbers(11);
  const PsychometricModel model;
  double sum = 0;
  double squares = 0;
  double errors = 0;
  int fits = 0;
  for (int i = 0; i < 300; ++i) {
    const Estimable<PsychometricFit> fit =
        fitPsychometric(model, answersOf(numbers, model, {0.2, std::log(4.0), 0.02}, 12));
    if (fit) {
      sum += fit->point.logThreshold - 0.2;
      squares += std::pow(fit->point.logThreshold - 0.2, 2);
      errors += fit->standardError;
      ++fits;
    }
  }
  ASSERT_EQ(fits, 300);
  EXPECT_NEAR(sum / fits, 0, 0.05);
  EXPECT_NEAR(std::sqrt(squares / fits) / (errors / fits), 1, 0.2);
}

TEST(Psychometric, SaysWhatItLacks) {
  const PsychometricModel model;
  EXPECT_EQ(fitPsychometric(model, {}).reason(), "there are no trials");
  EXPECT_EQ(fitPsychometric(model, {{0, 1, 2}}).reason(), "all trials have one level");
  EXPECT_EQ(fitPsychometric(model, {{0, 3, 3}, {1, 3, 3}}).reason(), "all answers are right");
  EXPECT_EQ(fitPsychometric(model, {{0, 0, 3}, {1, 0, 3}}).reason(), "all answers are wrong");
  EXPECT_EQ(fitPsychometric(model, {{0, 9, 10}, {1, 5, 10}, {2, 5, 10}}).reason(),
            "answers do not become better with the level");
  PsychometricModel wrong;
  wrong.guess = 1;
  EXPECT_THROW(fitPsychometric(wrong, {{0, 1, 2}, {1, 2, 2}}), InputError);
  EXPECT_THROW(levelCounts({1, 0}, {true, true}), InputError);
}

/// A likelihood that rises with the slope without end: the prior holds it.
TEST(Psychometric, SeparableAnswersHaveASlopeOfThePrior) {
  PsychometricModel model;
  model.guess = 0;
  const Estimable<PsychometricFit> fit = fitPsychometric(model, {{-1, 0, 9}, {0, 0, 9}, {1, 9, 9}, {2, 9, 9}});
  ASSERT_TRUE(fit);
  EXPECT_TRUE(fit->separable);
  EXPECT_FALSE(fit->outside);
  EXPECT_GT(fit->point.logThreshold, 0);
  EXPECT_LT(fit->point.logThreshold, 1);
  EXPECT_LT(fit->point.logSlope, model.logSlopeMean + 3 * model.logSlopeDeviation);
}

TEST(Psychometric, ThresholdsBeyondTheLevelsSaySo) {
  const PsychometricModel model;
  const Estimable<PsychometricFit> fit = fitPsychometric(model, {{0, 27, 30}, {0.5, 29, 30}, {1, 30, 30}});
  ASSERT_TRUE(fit);
  EXPECT_TRUE(fit->outside);
  EXPECT_LT(fit->point.logThreshold, 0);
}

TEST(Psychometric, CountsLevels) {
  const std::vector<LevelCounts> counts = levelCounts({2, 1, 2, 1, 2}, {true, false, true, true, false});
  ASSERT_EQ(counts.size(), 2u);
  EXPECT_EQ(counts[0].logLevel, 0);
  EXPECT_EQ(counts[0].right, 1);
  EXPECT_EQ(counts[1].right, 2);
  EXPECT_EQ(counts[1].trials, 3);
}

}  // namespace
}  // namespace ocelli::test
