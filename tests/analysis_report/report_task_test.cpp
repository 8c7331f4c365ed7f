#include "analysis/report/report_task.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/report/report_parts.h"
#include "tests/analysis_report/section_study.h"

namespace ocelli::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kSample = OCELLI_SOURCE_DIR "/protocols/rosen2010.plan.json";

TEST(DefaultPlan, HasNoHypothesesOfTasksThatTheStudyDoesNotHave) {
  const AnalysisPlan all = defaultPlan();
  const AnalysisPlan counting = defaultPlan(defaultConditions(), {"count", "nearer"});
  EXPECT_LT(counting.hypotheses.size(), all.hypotheses.size());
  for (const PlannedModel& model : counting.models) {
    EXPECT_TRUE(model.task == "count" || model.task == "survey") << model.name;
  }
  for (const Hypothesis& hypothesis : counting.hypotheses) {
    EXPECT_NE(counting.findModel(hypothesis.model), nullptr) << hypothesis.name;
  }
  const AnalysisPlan none = defaultPlan(defaultConditions(), {"nearer"});
  ASSERT_EQ(none.families.size(), 1u) << "the survey's";
  EXPECT_TRUE(none.equivalence.empty());
}

TEST(ReportTasks, defaultsAreThoseOfTheSample) {
  const AnalysisPlan sample = readPlan(kSample, plannableTasks(Dataset()));
  const AnalysisPlan plan = defaultPlan();
  EXPECT_FALSE(plan.isRegistered());
  EXPECT_TRUE(describe(plan).starts_with("no plan was registered: what is done are the defaults"));
  ASSERT_EQ(plan.models.size(), sample.models.size());
  for (size_t i = 0; i < plan.models.size(); ++i) {
    EXPECT_EQ(plan.models[i].name, sample.models[i].name);
    EXPECT_EQ(plan.models[i].task, sample.models[i].task);
    EXPECT_EQ(plan.models[i].kind, sample.models[i].kind);
    EXPECT_EQ(plan.models[i].terms, sample.models[i].terms);
    ASSERT_EQ(plan.models[i].randomEffects.size(), sample.models[i].randomEffects.size());
    for (size_t effect = 0; effect < plan.models[i].randomEffects.size(); ++effect) {
      EXPECT_EQ(plan.models[i].randomEffects[effect].slopes, sample.models[i].randomEffects[effect].slopes);
    }
  }
  ASSERT_EQ(plan.hypotheses.size(), sample.hypotheses.size());
  for (size_t i = 0; i < plan.hypotheses.size(); ++i) {
    EXPECT_EQ(plan.hypotheses[i].name, sample.hypotheses[i].name);
    EXPECT_EQ(plan.hypotheses[i].statement, sample.hypotheses[i].statement);
    EXPECT_EQ(plan.hypotheses[i].model, sample.hypotheses[i].model);
    EXPECT_EQ(plan.hypotheses[i].term, sample.hypotheses[i].term);
  }
  ASSERT_EQ(plan.families.size(), sample.families.size());
  EXPECT_EQ(plan.families[0].hypotheses, sample.families[0].hypotheses);
  EXPECT_EQ(plan.families[1].hypotheses, sample.families[1].hypotheses);
  EXPECT_EQ(plan.alpha, sample.alpha);
  EXPECT_EQ(plan.bootstrapSamples, sample.bootstrapSamples);
  EXPECT_EQ(plan.equivalence[0].upper, sample.equivalence[0].upper);
}

TEST(ReportTasks, haveOneRowAName) {
  std::set<std::string> names;
  for (const ReportTask& task : reportTasks()) {
    EXPECT_TRUE(names.insert(task.name).second) << task.name;
    EXPECT_EQ(reportTask(task.name).title, task.title);
    EXPECT_FALSE(task.parts.empty());
    for (const PlannedModel& model : task.models) {
      EXPECT_EQ(model.task, task.name);
      EXPECT_EQ(task.hasTrials, task.findModelKind(model.kind) != nullptr) << model.name;
    }
  }
}

TEST(ReportTasks, nameAllThatStudiesHave) {
  Dataset data;
  DataSource source;
  source.protocolText = R"({"name": "a", "blocks": [{"name": "b", "task": "nearer"}, {"name": "c", "task": "find"}]})";
  data.sources = {source};
  Trial trial;
  trial.task = "older";
  data.trials = {trial};
  EXPECT_THAT(plannableTasks(data), ElementsAre("find", "count", "path", "survey", "nearer", "older"));
}

/// A task that nobody knows is no other task: models and words are its own.
TEST(ReportTasks, unknownTasksStayThemselves) {
  const ReportTask task = reportTask("nearer");
  EXPECT_EQ(task.name, "nearer");
  EXPECT_EQ(wordsOf(task.models[0]), "Binomial mixed model of right answers of nearer (task-nearer-right)");
  EXPECT_EQ(wordsOf(task.models[1]), "Log-normal mixed model of times of nearer (task-nearer-time)");
  EXPECT_EQ(modelsOfTask(defaultPlan(), task).size(), 2u);
  EXPECT_THAT(task.models[0].terms, ElementsAre("view")) << "of one session nothing can be told of sessions";
  EXPECT_THAT(reportTask("nearer", {false, false, true}).models[0].terms, ElementsAre("view", "session"));
  AnalysisPlan plan = defaultPlan();
  plan.models.push_back({"mine", "nearer", ModelKind::kEquivalence});
  ASSERT_EQ(modelsOfTask(plan, task).size(), 1u);
  EXPECT_EQ(modelsOfTask(plan, task)[0].name, "mine");
  plan.models.clear();
  EXPECT_TRUE(modelsOfTask(plan, reportTask("count")).empty()) << "a plan may leave a task out";
}

}  // namespace
}  // namespace ocelli::test
