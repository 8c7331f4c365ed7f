// How near QUEST+ comes to thresholds that are known, over hundreds of simulated runs.
#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/random.h"
#include "study/agent/chance.h"
#include "study/protocol/quest_plus.h"
#include "tests/study_protocol/staircase_levels.h"

namespace ocelli {
namespace {

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
      answers.push_back({level, happens(random, subject.right(std::log(staircaseLevels()[level])))});
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
  const QuestPlus quest(staircaseLevels(), options);
  for (const double threshold : {0.06, 0.12, 0.25}) {
    const PsychometricFunction subject{&psychometricShapes()[0], std::log(threshold), 2, 0.5, 0.02};
    const Accuracy accuracy = accuracyOf(quest, subject, 40, 500);
    EXPECT_LT(std::abs(accuracy.bias), 0.115) << threshold << ": -0.080, -0.079, -0.064 were measured";
    EXPECT_LT(accuracy.rmse, 0.275) << threshold << ": 0.229, 0.251, 0.223 were measured";
  }
}

TEST(QuestPlus, MoreTrialsErrLess) {
  const QuestPlus quest(staircaseLevels(), {});
  const PsychometricFunction subject{&psychometricShapes()[0], std::log(0.12), 2, 0.5, 0.02};
  const double few = accuracyOf(quest, subject, 20, 150).rmse;
  const double many = accuracyOf(quest, subject, 80, 150).rmse;
  EXPECT_LT(many, 0.75 * few)
      << "0.174 and 0.318 were measured in 500 runs; by the square root of the trials it is a half";
}

}  // namespace
}  // namespace ocelli
