// QUEST+ against Bayes by brute force, and how well it finds thresholds that are known.
#include "study/protocol/quest_plus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "oc_core/base/random.h"
#include "study/agent/chance.h"

namespace ocelli {
namespace {

/// 16 levels from 0.02 to 0.64 by equal factors.
std::vector<double> levels() {
  std::vector<double> all;
  for (int i = 0; i < 16; ++i) {
    all.push_back(0.02 * std::pow(2, i / 3.0));
  }
  return all;
}

/// Written plainly: the product of the chances of the answers, each function by itself.
std::vector<double> slowPosterior(const QuestPlus& quest, const std::vector<LevelAnswer>& answers) {
  std::vector<double> weights;
  for (const PsychometricFunction& function : quest.grid()) {
    double weight = 1;
    for (const LevelAnswer& answer : answers) {
      const double x = levels()[answer.level] / std::exp(function.logThreshold);
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
  const QuestPlus quest(levels(), {});
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
  const QuestPlus quest(levels(), {});
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
        right += known[i] * quest.grid()[i].right(std::log(levels()[level]));
      }
      expected.push_back(right * afterRight + (1 - right) * afterWrong);
      EXPECT_NEAR(quest.expectedGain(known, level), slowEntropy(known) - expected.back(), 1e-7);  // likewise
      least = std::min(least, expected.back());
    }
    EXPECT_NEAR(expected[quest.next(answers)], least, 1e-7);
  }
}

TEST(QuestPlus, TheOrderOfAnswersDoesNotMatter) {
  const QuestPlus quest(levels(), {});
  Random random(5);
  std::vector<LevelAnswer> answers = someAnswers(random, 30);
  const size_t next = quest.next(answers);
  const double threshold = quest.threshold(answers).value();
  random.shuffle(answers);
  EXPECT_EQ(quest.next(answers), next);
  EXPECT_NEAR(quest.threshold(answers).value(), threshold, 1e-12);
}

struct Accuracy {
  double bias = 0;  ///< of the logarithm of the threshold
  double rmse = 0;
};

Accuracy accuracyOf(const QuestPlus& quest, const PsychometricFunction& subject, int trials, int runs) {
  Random random(11);
  double sum = 0;
  double squares = 0;
  for (int run = 0; run < runs; ++run) {
    std::vector<LevelAnswer> answers;
    for (int i = 0; i < trials; ++i) {
      const size_t level = quest.next(answers);
      answers.push_back({level, happens(random, subject.right(std::log(levels()[level])))});
    }
    const double error = std::log(quest.threshold(answers).value()) - subject.logThreshold;
    sum += error;
    squares += error * error;
  }
  return {sum / runs, std::sqrt(squares / runs)};
}

// 500 runs of 40 trials with two choices; errors are of the natural logarithm of the threshold, so that 0.3 is some
// 30 %. The tolerances are the values that were measured and three standard errors: of the mean, error / sqrt(500); of
// the root mean square, about error / sqrt(1000).
TEST(QuestPlus, FindsThresholdsThatAreKnown) {
  QuestPlusOptions options;
  const QuestPlus quest(levels(), options);
  for (const double threshold : {0.06, 0.12, 0.25}) {
    const PsychometricFunction subject{&psychometricShapes()[0], std::log(threshold), 2, 0.5, 0.02};
    const Accuracy accuracy = accuracyOf(quest, subject, 40, 500);
    EXPECT_LT(std::abs(accuracy.bias), 0.115) << threshold << ": -0.080, -0.079, -0.064 were measured";
    EXPECT_LT(accuracy.rmse, 0.275) << threshold << ": 0.229, 0.251, 0.223 were measured";
  }
}

TEST(QuestPlus, MoreTrialsErrLess) {
  const QuestPlus quest(levels(), {});
  const PsychometricFunction subject{&psychometricShapes()[0], std::log(0.12), 2, 0.5, 0.02};
  const double few = accuracyOf(quest, subject, 20, 150).rmse;
  const double many = accuracyOf(quest, subject, 80, 150).rmse;
  EXPECT_LT(many, 0.75 * few)
      << "0.174 and 0.318 were measured in 500 runs; by the square root of the trials it is a half";
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
