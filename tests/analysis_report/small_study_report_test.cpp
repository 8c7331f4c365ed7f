// Reports of studies that hold next to nothing, or the same everywhere: what cannot be estimated says so in its place.
#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/report/html_report.h"
#include "analysis/report/report_parts.h"
#include "tests/analysis_report/study_report_fixture.h"

namespace ocelli::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

using SmallStudyReport = StudyReportTest;

TEST_F(SmallStudyReport, nobodyIsNoCrash) {
  const nlohmann::json report = reportOf([](SampleStudy&) {});
  expectHonest(report);
  EXPECT_GE(notEstimable(report).size(), 4u) << "one for each task";
  EXPECT_EQ(valueOfCell(report, "subjects/analysed"), 0);
}

TEST_F(SmallStudyReport, subjectsWithoutTrialsAreNotAnalysed) {
  const nlohmann::json report = reportOfMade(only([](const SampleTrial&) { return false; }));
  expectHonest(report);
  EXPECT_EQ(valueOfCell(report, "subjects/enrolled"), 6);
  EXPECT_EQ(valueOfCell(report, "subjects/analysed"), 0);
  EXPECT_GE(notEstimable(report).size(), 3u);
}

TEST_F(SmallStudyReport, oneTrialIsNoStudy) {
  const nlohmann::json report =
      reportOfMade(only([](const SampleTrial& trial) { return trial.subject == "S01" && trial.plan == 0; }));
  expectHonest(report);
  EXPECT_FALSE(valueIn(report, "find-time", "view", "Estimate"));
  EXPECT_FALSE(valueIn(report, "find-hazard", "view", "Estimate"));
}

TEST_F(SmallStudyReport, oneSubjectHasNoPopulation) {
  MadeStudy made;
  made.subjects = 1;
  const nlohmann::json report = reportOfMade(made);
  expectHonest(report);
  for (const char* model : {"find-time", "find-hazard", "find-log-normal", "count-right", "path-right"}) {
    EXPECT_FALSE(valueIn(report, model, "view", "Estimate")) << model;
    EXPECT_THAT(notEstimable(report), Contains(HasSubstr(model)));
  }
  EXPECT_FALSE(valueIn(report, "find-survival", "restricted mean", "Estimate")) << "errors are of subjects";
  EXPECT_THAT(notEstimable(report), Contains(HasSubstr("Bands of the survival curve of pinhole")));
  EXPECT_FALSE(valueIn(report, "path-equivalence", "p of", "Value"));
}

TEST_F(SmallStudyReport, oneViewHasNoEffectOfViews) {
  for (const char* view : {"ppc", "gc"}) {
    const nlohmann::json report = reportOfMade(only([&](const SampleTrial& trial) { return trial.view == view; }));
    expectHonest(report);
    for (const char* model : {"find-time", "find-hazard", "find-log-normal", "count-right", "path-right"}) {
      EXPECT_FALSE(valueIn(report, model, "view", "Estimate")) << model << ", " << view;
    }
    EXPECT_FALSE(valueIn(report, "find-survival", "gc less ppc", "Estimate"));
    EXPECT_FALSE(valueIn(report, "count-matched", "difference", "Estimate"));
    for (const char* hypothesis : {"find-faster", "count-better", "path-alike"}) {
      EXPECT_FALSE(valueIn(report, "family-primary", hypothesis, "p")) << hypothesis;
    }
  }
}

TEST_F(SmallStudyReport, searchesThatNeverEndHaveNoTimes) {
  const nlohmann::json report = reportOfMade(changed([](SampleTrial& trial) {
    if (trial.task == "find") {
      trial.response = 60;
      trial.censored = true;
      trial.correct = false;
      trial.answer = "";
    }
  }));
  expectHonest(report);
  for (const char* row : {"ppc: median", "gc: median", "ppc: restricted", "gc: restricted", "gc less ppc"}) {
    EXPECT_FALSE(valueIn(report, "find-survival", row, "Estimate")) << row;
  }
  for (const char* model : {"find-time", "find-hazard", "find-log-normal"}) {
    EXPECT_FALSE(valueIn(report, model, "view", "Estimate")) << model;
  }
  EXPECT_FALSE(valueOfCell(report, "section-7.4.2/stationary/ppc")) << "the text's mean is of searches that ended";
  EXPECT_EQ(valueOfCell(report, "time-outs/stationary/ppc"), 100);
}

TEST_F(SmallStudyReport, searchesThatNeverEndInOneViewHaveNoHazardRatio) {
  const nlohmann::json report = reportOfMade(changed([](SampleTrial& trial) {
    if (trial.task == "find" && trial.view == "gc") {
      trial.response = 60;
      trial.censored = true;
    }
  }));
  expectHonest(report);
  EXPECT_FALSE(valueIn(report, "find-hazard", "view", "Estimate"));
  EXPECT_FALSE(valueIn(report, "find-log-normal", "view", "Estimate"));
  EXPECT_TRUE(valueIn(report, "find-survival", "ppc: restricted", "Estimate"));
  EXPECT_FALSE(valueIn(report, "find-survival", "gc: restricted", "Estimate"));
}

TEST_F(SmallStudyReport, separatedAnswersHaveNoOddsRatio) {
  const nlohmann::json report = reportOfMade(changed([](SampleTrial& trial) {
    trial.correct = trial.view == "gc";
    trial.response = trial.view == "gc" ? 5 : 30;
    trial.censored = false;
  }));
  expectHonest(report);
  EXPECT_FALSE(valueIn(report, "count-right", "view", "Estimate"));
  EXPECT_FALSE(valueIn(report, "path-right", "view", "Estimate"));
  EXPECT_FALSE(valueIn(report, "find-hazard", "view", "Estimate"));
  EXPECT_FALSE(valueIn(report, "count-matched", "Odds ratio", "Estimate"));
  EXPECT_THAT(notEstimable(report), Contains(HasSubstr("count-right")));
}

TEST_F(SmallStudyReport, constantResponsesHaveNoSpread) {
  MadeStudy made = changed([](SampleTrial& trial) {
    trial.correct = true;
    trial.answer = trial.expected;
    trial.response = 7;
    trial.censored = false;
  });
  made.surveyAnswer = "3";
  const nlohmann::json report = reportOfMade(made);
  expectHonest(report);
  for (const char* model : {"find-time", "find-hazard", "find-log-normal", "count-right", "path-right"}) {
    EXPECT_FALSE(valueIn(report, model, "view", "Estimate")) << model;
  }
  for (const char* hypothesis : {"find-faster", "count-better", "path-alike"}) {
    EXPECT_FALSE(valueIn(report, "family-primary", hypothesis, "p")) << hypothesis;
  }
  EXPECT_FALSE(valueIn(report, "family-secondary", "survey-preference", "p"));
}

TEST_F(SmallStudyReport, missingSessionsAreNoEffectOfSessions) {
  // Nobody came again; then only one subject did.
  for (const char* whoCameAgain : {"", "S03"}) {
    const nlohmann::json report = reportOfMade(
        only([&](const SampleTrial& trial) { return trial.session == 1 || trial.subject == whoCameAgain; }));
    expectHonest(report);
    EXPECT_TRUE(valueIn(report, "find-time", "view", "Estimate"));
    EXPECT_FALSE(valueOfCell(report, "table-7.1/stationary/session-2/ppc")) << "nobody completed three sessions";
    if (*whoCameAgain == '\0') {
      EXPECT_FALSE(valueIn(report, "count-right", "session", "Estimate"));
    }
  }
}

TEST_F(SmallStudyReport, searchesOfNoTimeAreSaidToBeLeftOut) {
  const nlohmann::json report = reportOfMade(changed([](SampleTrial& trial) {
    if (trial.task == "find" && trial.caseIndex == 0) {
      trial.response = 0;
    }
  }));
  expectHonest(report);
  EXPECT_TRUE(valueIn(report, "find-time", "view", "Estimate"));
  EXPECT_FALSE(valueIn(report, "find-log-normal", "view", "Estimate")) << "0 s has no logarithm";
  bool said = false;
  for (const nlohmann::json& element : report["elements"]) {
    said =
        said || (element["type"] == "note" && element["text"].get<std::string>().starts_with("48 searches took 0 s"));
  }
  EXPECT_TRUE(said);
}

TEST_F(SmallStudyReport, absurdCountsAreNoOverflow) {
  const nlohmann::json report = reportOfMade(changed([](SampleTrial& trial) {
    if (trial.task == "count") {
      trial.answer = trial.caseIndex == 0 ? "9999999999999999999999999999" : trial.caseIndex == 1 ? "-1e300" : "many";
      trial.correct = false;
    }
  }));
  expectHonest(report);
}

TEST_F(SmallStudyReport, valuesThatTheSchemaLeavesOutAreMissing) {
  const nlohmann::json report = reportOf([](SampleStudy& study) {
    fillWholeStudy(study);
    study.database().exec("DROP TRIGGER trial_update");
    study.database().exec(
        "UPDATE trial SET response_s = NULL, correct = NULL, censored = NULL, moving = NULL, exposure_s = NULL, "
        "objects = NULL, duplicate_colors = NULL, answer = NULL, expected = NULL, case_label = NULL, "
        "longest_s = NULL, frames = NULL, dropped_frames = NULL, timing_verdict = NULL");
  });
  expectHonest(report);
  EXPECT_GE(notEstimable(report).size(), 3u);
  EXPECT_FALSE(valueOfCell(report, "time-outs/stationary/ppc"));
}

TEST_F(SmallStudyReport, simulatedSubjectsAreSaidToBeOnEveryWriter) {
  MadeStudy made;
  made.kind = "simulated_generator";
  const nlohmann::json report = reportOfMade(made);
  EXPECT_EQ(report["marking"], "Simulated subjects");
  EXPECT_THAT(htmlReport(document_), HasSubstr("class=\"marking\">Simulated subjects"));
  EXPECT_EQ(reportOfMade({}).count("marking"), 0u);
}

}  // namespace
}  // namespace ocelli::test
