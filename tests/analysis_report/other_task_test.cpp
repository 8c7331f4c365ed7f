// A task that has no row appears in the report, and is no other task there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "analysis/dataset/database.h"
#include "analysis/dataset/merge.h"
#include "analysis/report/json_report.h"
#include "analysis/report/report_task.h"
#include "analysis/report/study_report.h"
#include "tests/analysis_dataset/made_study.h"
#include "tests/analysis_report/report_reading.h"

namespace ocelli::test {
namespace {

using ::testing::IsEmpty;
using ::testing::IsSupersetOf;

class OtherTask : public testing::Test {
 protected:
  /// Of the whole study, with paths as a task of another name.
  nlohmann::json reportOf(const std::string& task, AnalysisPlan plan = defaultPlan()) {
    MadeStudy made;
    made.change = [&](SampleTrial& trial) {
      if (trial.task == "path") {
        trial.task = task;
        trial.response = 2 + 0.1 * ((7 * *trial.plan + trial.session) % 11);  // all take 3 s else
      }
      return true;
    };
    const std::string path = folder_.file(task + ".db");
    {
      SampleStudy study(path, kWholeProtocol);
      fillWholeStudy(study, made);
    }
    plan.bootstrapSamples = 100;
    analysis_ = applyPlan(merge({readDatabase(path)}), plan);
    document_ = studyReport(analysis_, {}, {{}, "1.2.3"});
    return nlohmann::json::parse(jsonReport(document_));
  }

  SampleFolder folder_;
  AnalysisData analysis_;
  ReportDocument document_;
};

TEST_F(OtherTask, isReportedWithTheUsualModels) {
  const nlohmann::json report = reportOf("nearer");
  EXPECT_THAT(document_.failures, IsEmpty());
  EXPECT_THAT(dishonestNumbers(report), IsEmpty());
  EXPECT_EQ(elementOf(report, "task-nearer")["text"], "Task nearer");
  const auto estimate = valueIn(report, "task-nearer-right", "view (gc / ppc)", "Estimate");
  ASSERT_TRUE(estimate);
  EXPECT_TRUE(valueIn(report, "task-nearer-time", "view (gc / ppc)", "Estimate"));
  EXPECT_TRUE(valueIn(report, "task-nearer-shares", "ppc, session 1", "Estimate"));
  EXPECT_TRUE(valueIn(report, "task-nearer-times", "All trials", "gc / ppc"));
  EXPECT_TRUE(valueIn(report, "learning-nearer-right", "Session 1", "ppc"));
  // The same data as a task with a row give the same answer, and are not in that task's section here.
  EXPECT_EQ(estimate, valueIn(reportOf("path"), "path-right", "view (gc / ppc)", "Estimate"));
}

TEST_F(OtherTask, isNoOtherTask) {
  const nlohmann::json report = reportOf("nearer");
  EXPECT_TRUE(elementOf(report, "path-right").is_null());
  EXPECT_THAT(notEstimable(report), IsSupersetOf({"Paths: there are no trials of this task."}));
  EXPECT_EQ(elementOf(report, "survey")["text"], "What subjects say");
}

/// Also where it has the name of a form, or of another task in capital letters.
TEST_F(OtherTask, isNoOtherTaskWhateverItsName) {
  nlohmann::json report = reportOf("survey");
  EXPECT_EQ(elementOf(report, "task-survey")["text"], "Task survey");
  EXPECT_TRUE(valueIn(report, "task-survey-shares", "ppc, session 1", "Estimate"));
  EXPECT_EQ(elementOf(report, "survey")["text"], "What subjects say");
  report = reportOf("Find");
  EXPECT_EQ(elementOf(report, "task-find")["text"], "Task Find");
  EXPECT_TRUE(valueIn(report, "task-find-right", "view (gc / ppc)", "Estimate"));
  EXPECT_THAT(document_.failures, IsEmpty());
}

TEST_F(OtherTask, hasTheModelsOfThePlanWhereThatNamesIt) {
  AnalysisPlan plan = defaultPlan();
  plan.models.push_back({"my-right", "nearer", ModelKind::kBinomialMixed, {"view"}, {{"subject"}}});
  plan.models.push_back({"my-pairs", "nearer", ModelKind::kMcNemar});
  plan.models.push_back({"my-bounds", "nearer", ModelKind::kEquivalence});
  plan.equivalence.push_back({"nearer", -0.2, 0.2});
  const nlohmann::json report = reportOf("nearer", plan);
  EXPECT_TRUE(valueIn(report, "my-right", "view (gc / ppc)", "Estimate"));
  EXPECT_TRUE(valueIn(report, "my-bounds", "Difference of shares", "Value"));
  EXPECT_TRUE(elementOf(report, "task-nearer-right").is_null());
  EXPECT_THAT(notEstimable(report), IsSupersetOf({"McNemar's test of right answers of nearer (my-pairs): mcnemar is "
                                                  "not done for trials of nearer."}));
}

}  // namespace
}  // namespace ocelli::test
