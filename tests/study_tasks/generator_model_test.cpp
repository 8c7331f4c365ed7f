#include "study/tasks/generator_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

TEST(GeneratorModel, HasALevelFirstAndWhatAllModelsHave) {
  for (const TaskKind& kind : taskKinds()) {
    SCOPED_TRACE(kind.name);
    const GeneratorModel& model = kind.generator;
    ASSERT_FALSE(model.effects.empty());
    EXPECT_EQ(model.effects.front().covariate, levelCovariate);
    for (const char* name : {kGraphEffect, kSubjectSd, kItemSd, kItemViewSd}) {
      EXPECT_TRUE(model.indexOf(name)) << name;
    }
    EXPECT_EQ(model.effects[*model.indexOf(kGraphEffect)].covariate, graphCovariate);
    EXPECT_EQ(model.indexOf(kResidualSd).has_value(), kind.outcome != OutcomeKind::kAnswer);
    EXPECT_EQ(model.unit != nullptr, kind.outcome == OutcomeKind::kEstimate);
    EXPECT_EQ(model.rightWithin > 0, kind.outcome == OutcomeKind::kEstimate);
    EXPECT_EQ(model.wrongAnswer != nullptr, kind.outcome == OutcomeKind::kAnswer);
    for (const GeneratorEffect& effect : model.effects) {
      EXPECT_STRNE(effect.meaning, "") << effect.name;
      EXPECT_EQ(effect.covariate == nullptr, std::string_view(effect.name).ends_with("_sd")) << effect.name;
      EXPECT_TRUE(effect.covariate != nullptr || effect.value >= 0) << effect.name;
    }
  }
}

TEST(GeneratorModel, CovariatesAreOfTheTrial) {
  GeneratedTrial trial;
  trial.session = 3;
  EXPECT_EQ(levelCovariate(trial), 1);
  EXPECT_EQ(graphCovariate(trial), 0);
  EXPECT_EQ(sessionCovariate(trial), 2);
  trial.view = TrialView::kOther;
  EXPECT_EQ(graphCovariate(trial), 1);
  const GeneratorModel& count = taskKind("count", "test").generator;
  trial.info.exposureSeconds = 40;
  EXPECT_EQ(count.effects[*count.indexOf("doubled_exposure")].covariate(trial), 2);
  EXPECT_EQ(count.effects[*count.indexOf("duplicates")].covariate(trial), 0);
  trial.info.duplicateColors = true;
  EXPECT_EQ(count.effects[*count.indexOf("duplicates")].covariate(trial), 1);
}

TEST(GeneratorModel, WrongAnswersAreWrong) {
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    EXPECT_NE(taskKind("count", "test").generator.wrongAnswer("5", random), "5");
    EXPECT_EQ(taskKind("nearer", "test").generator.wrongAnswer("left", random), "right");
    EXPECT_EQ(taskKind("nearer", "test").generator.wrongAnswer("right", random), "left");
    EXPECT_EQ(taskKind("path", "test").generator.wrongAnswer("LRL", random), "other");
  }
}

}  // namespace
}  // namespace ocelli
