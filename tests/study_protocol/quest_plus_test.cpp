// QUEST+ against Bayes by brute force, and how well it finds thresholds that are known.
#include "study/protocol/quest_plus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "oc_core/base/random.h"
#include "study/agent/chance.h"
#include "tests/study_protocol/staircase_levels.h"

namespace ocelli {
namespace {

/// Written plainly: the product of the chances of the answers, each function by itself.
std::vector<double> slowPosterior(const QuestPlus& quest, const std::vector<LevelAnswer>& answers) {
  std::vector<double> weights;
  for (const PsychometricFunction& function : quest.grid()) {
    double weight = 1;
    for (const LevelAnswer& answer : answers) {
      const double x = staircaseLevels()[answer.level] / std::exp(function.logThreshold);
      const double shape = 1 - std::exp(-std::pow(x, function.slope));
      const double right = function.guessRate + (1 - function.guessRate - function.lapseRate) * shape;
      weight *= answer.correct ? right : 1 - right;
    }
    weights.push_back(weight);
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) {
    weight /= sum;
  }
  return weights;
}

double slowEntropy(const std::vector<double>& weights) {
  double entropy = 0;
  for (const double weight : weights) {
    entropy -= weight > 0 ? weight * std::log(weight) : 0;
  }
  return entropy;
}

std::vector<LevelAnswer> someAnswers(Random& random, int count) {
  std::vector<LevelAnswer> answers;
  for (int i = 0; i < count; ++i) {
    const auto level = static_cast<size_t>(random.below(16));
    answers.push_back({level, happens(random, 0.5 + 0.03 * static_cast<double>(level))});
  }
  return answers;
}

TEST(QuestPlus, PosteriorIsThatOfBayes) {
  const QuestPlus quest(staircaseLevels(), {});
  ASSERT_EQ(quest.grid().size(), 41u * 9 * 4);
  Random random(3);
  for (const int count : {0, 1, 5, 40}) {
    const std::vector<LevelAnswer> answers = someAnswers(random, count);
    const std::vector<double> fast = quest.posterior(answers);
    const std::vector<double> slow = slowPosterior(quest, answers);
    ASSERT_EQ(fast.size(), slow.size());
    for (size_t i = 0; i < fast.size(); ++i) {
      ASSERT_NEAR(fast[i], slow[i], 1e-7 * slow[i] + 1e-9);  // chances stay 1e-9 from 0 and 1
    }
  }
}

TEST(QuestPlus, NextIsTheLevelOfLeastExpectedEntropy) {
  const QuestPlus quest(staircaseLevels(), {});
  Random random(4);
  for (const int count : {0, 3, 20}) {
    std::vector<LevelAnswer> answers = someAnswers(random, count);
    const std::vector<double> known = slowPosterior(quest, answers);
    double least = 1e9;
    std::vector<double> expected;
    for (size_t level = 0; level < 16; ++level) {
      answers.push_back({level, true});
      const double afterRight = slowEntropy(slowPosterior(quest, answers));
      answers.back().correct = false;
      const double afterWrong = slowEntropy(slowPosterior(quest, answers));
      answers.pop_back();
      double right = 0;
      for (size_t i = 0; i < known.size(); ++i) {
        right += known[i] * quest.grid()[i].right(std::log(staircaseLevels()[level]));
      }
      expected.push_back(right * afterRight + (1 - right) * afterWrong);
      EXPECT_NEAR(quest.expectedGain(known, level), slowEntropy(known) - expected.back(), 1e-7);  // likewise
      least = std::min(least, expected.back());
    }
    EXPECT_NEAR(expected[quest.next(answers)], least, 1e-7);
  }
}

TEST(QuestPlus, TheOrderOfAnswersDoesNotMatter) {
  const QuestPlus quest(staircaseLevels(), {});
  Random random(5);
  std::vector<LevelAnswer> answers = someAnswers(random, 30);
  const size_t next = quest.next(answers);
  const double threshold = quest.threshold(answers).value();
  random.shuffle(answers);
  EXPECT_EQ(quest.next(answers), next);
  EXPECT_NEAR(quest.threshold(answers).value(), threshold, 1e-12);
}

TEST(PsychometricFunction, RunsFromGuessingToTheBest) {
  const PsychometricFunction function{&psychometricShape("logistic", "test"), std::log(0.2), 3, 0.25, 0.05};
  EXPECT_NEAR(function.right(std::log(0.2)), 0.25 + 0.7 / 2, 1e-15);
  EXPECT_NEAR(function.right(std::log(0.4)), 0.25 + 0.7 * 8 / 9, 1e-15);
  EXPECT_NEAR(function.right(-100), 0.25, 1e-15);
  EXPECT_NEAR(function.right(100), 0.95, 1e-15);
}

}  // namespace
}  // namespace ocelli
