// The whole report of small studies: that its numbers are those of the data, and that it says where there are none.
#include "analysis/report/study_report.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "analysis/dataset/database.h"
#include "analysis/dataset/merge.h"
#include "analysis/inference/kaplan_meier.h"
#include "analysis/report/html_report.h"
#include "analysis/report/json_report.h"
#include "analysis/report/report_files.h"
#include "analysis/report/report_parts.h"
#include "analysis/report/report_task.h"
#include "analysis/report/resampled_effects.h"
#include "analysis/report/search_times.h"
#include "analysis/tables/paper_tables.h"
#include "tests/analysis_dataset/made_study.h"
#include "tests/analysis_report/study_report_fixture.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

using StudyReport = StudyReportTest;

TEST_F(StudyReport, aWholeStudyIsAnsweredAndHonest) {
  const nlohmann::json report = reportOfMade({});
  expectHonest(report);
  // It has no logs, one order of cases, and nobody with all sessions.
  EXPECT_THAT(notEstimable(report), Each(AnyOf(HasSubstr("has a log"), HasSubstr("halves would differ in their cases"),
                                               HasSubstr("there is one group only"))));
  for (const char* id : {"design", "flow", "paper", "find", "navigation", "count", "path", "learning", "completers",
                         "survey", "hypotheses", "methods", "apparatus", "provenance"}) {
    EXPECT_FALSE(elementOf(report, id).is_null()) << id;
  }
  EXPECT_THAT(htmlSupplement(document_), HasSubstr(analysis_.dataSha256));
}

TEST_F(StudyReport, effectsHaveTheirDirections) {
  // Twice the subjects, so that no draw hides them.
  MadeStudy made;
  made.subjects = 12;
  made.change = [](SampleTrial& trial) {
    if (trial.task == "path" && trial.view == "gc" && trial.caseIndex < 2) {
      trial.correct = false;
      trial.answer = "map 2";
    }
    return true;
  };
  const nlohmann::json report = reportOfMade(made);
  const auto estimate = [&](const char* table, const char* row) {
    return valueIn(report, table, row, "Estimate").value_or(NAN);
  };
  EXPECT_NEAR(std::log(estimate("find-time", "view")), -std::log(1.5), 0.15) << "standard error 0.06";
  EXPECT_LT(estimate("find-survival", "gc less ppc"), -1);
  EXPECT_GT(estimate("find-hazard", "view"), 1.3);
  EXPECT_NEAR(std::log(estimate("find-log-normal", "view")), -std::log(1.5), 0.15);
  EXPECT_GT(estimate("count-right", "view"), 1.5);
  EXPECT_GT(estimate("count-matched", "difference"), 0.05);
  EXPECT_LT(estimate("path-right", "view"), 0.7);
  EXPECT_LT(valueIn(report, "path-equivalence", "Difference", "Value").value_or(NAN), -0.1);
  EXPECT_GT(estimate("count-shares", "gc, session 1"), estimate("count-shares", "ppc, session 1"));
}

TEST_F(StudyReport, intervalsOfMediansTakeSubjectsAndCasesAsClusters) {
  const nlohmann::json report = reportOfMade({});
  const TrialList seen = trialsOfView(trialsOfTask(analysis_, "find"), TrialView::kReference);
  const std::vector<SurvivalTime> times = timesOf(seen, TimeoutTreatment::kCensored);
  const auto textOf = [](const SurvivalCurve& curve) {
    const Estimate median = *medianTime(curve);
    return textsOf(median).interval;
  };
  const std::string clustered = textOf(*survivalCurve(times, 0.95, numbered(subjectsOf(seen)), caseNumbers(seen)));
  const std::string naive = textOf(*survivalCurve(times));
  ASSERT_NE(clustered, naive);
  EXPECT_THAT(elementOf(report, "find-survival").dump(), AllOf(HasSubstr(clustered), Not(HasSubstr(naive))));
}

/// Searches of six subjects, who all do the same: with the pinhole 10, 20 and twice the limit of 60 s, with the graph
/// camera half of the times.
void fillCensored(SampleStudy& study, const char* lastEnding = "completed") {
  for (int s = 0; s < 6; ++s) {
    const std::string subject = fmt::format("S{}", s);
    study.addSubject(subject);
    study.addSession(subject, 1, s == 5 ? lastEnding : "completed");
    int plan = 0;
    for (const char* view : {"ppc", "gc"}) {
      for (const double seconds : {10.0, 20.0, 60.0, 60.0, 60.0}) {
        SampleTrial trial;
        trial.subject = subject;
        trial.view = view;
        trial.caseIndex = plan % 5;
        trial.plan = plan++;
        // Subjects differ a little, or nothing would be uncertain.
        trial.response = (*trial.plan < 5 ? 1.0 : 0.5) * seconds + (seconds < 60 ? 0.5 * s : 0.0);
        trial.censored = trial.response == 60;
        trial.correct = !trial.censored;
        study.addTrial(trial);
      }
    }
  }
}

TEST_F(StudyReport, timeoutsAreCensored) {
  const nlohmann::json report = reportOf([](SampleStudy& study) { fillCensored(study); });
  expectHonest(report);
  // Three of five searches with the pinhole never ended: the curve does not fall to a half. Taken as found at 60 s, or
  // left out, they would give 60 s or 15 s.
  EXPECT_FALSE(valueIn(report, "find-survival", "ppc: median", "Estimate"));
  EXPECT_THAT(notEstimable(report), Contains(HasSubstr("Pinhole: median")));
  EXPECT_EQ(valueIn(report, "find-survival", "gc: median", "Estimate"), 30);
  // Means of 10, 20, 60, 60, 60 and of 5, 10, 30, 30, 30, with what subjects differ by: 0 to 2.5 s in two of five.
  const double more = 2.0 / 5 * 1.25;
  EXPECT_NEAR(valueIn(report, "find-survival", "ppc: restricted mean", "Estimate").value_or(NAN), 42 + more, 1e-9);
  EXPECT_NEAR(valueIn(report, "find-survival", "gc less ppc", "Estimate").value_or(NAN), -21, 1e-9);
}

TEST_F(StudyReport, timeoutsAreRemovedOrSetToTheLimitWhereThePlanSaysSo) {
  const auto fill = [](SampleStudy& study) { fillCensored(study); };
  AnalysisPlan plan = defaultPlan();
  plan.findTimeouts = TimeoutTreatment::kSetToLimit;
  EXPECT_EQ(valueIn(reportOf(fill, plan), "find-survival", "ppc: median", "Estimate"), 60);
  plan.findTimeouts = TimeoutTreatment::kRemoved;
  const double median = valueIn(reportOf(fill, plan), "find-survival", "ppc: median", "Estimate").value_or(NAN);
  EXPECT_GE(median, 10);
  EXPECT_LE(median, 22.5);
}

/// A limit of 15 s cuts off what the views differ in most. What tests the hypothesis knows that it did.
TEST_F(StudyReport, testsOfSearchesRespectTimeOuts) {
  MadeStudy made;
  made.subjects = 12;
  made.change = [](SampleTrial& trial) {
    if (trial.task == "find" && trial.response > 15) {
      trial.response = 15;
      trial.censored = true;
      trial.correct = false;
      trial.answer = "";
    }
    return true;
  };
  const auto logRatioOf = [&](TimeoutTreatment timeouts) {
    AnalysisPlan plan = defaultPlan();
    plan.findTimeouts = timeouts;
    const nlohmann::json report = reportOfMade(made, plan);
    expectHonest(report);
    const std::optional<double> ratio = valueIn(report, "find-time", "view", "Estimate");
    EXPECT_EQ(valueIn(report, "find-time", "view", "p"), valueIn(report, "family-primary", "find-faster", "p"));
    return std::log(ratio.value_or(NAN));
  };
  const double censored = logRatioOf(TimeoutTreatment::kCensored);
  EXPECT_THAT(htmlReport(document_), HasSubstr("in which searches that the limit ended count as censored"));
  EXPECT_THAT(htmlReport(document_),
              HasSubstr("Random effects as planned: (1 + view || subject) + (1 + view || case)"));
  EXPECT_NEAR(censored, -std::log(1.5), 0.15);
  EXPECT_GT(logRatioOf(TimeoutTreatment::kSetToLimit), censored + 0.05);
  EXPECT_THAT(htmlReport(document_),
              HasSubstr("in which searches that the limit ended count as if they had ended then"));
  EXPECT_GT(logRatioOf(TimeoutTreatment::kRemoved), censored + 0.05);
  EXPECT_THAT(htmlReport(document_), HasSubstr("in which searches that the limit ended are left out"));
}

TEST_F(StudyReport, whoIsExcludedIsInNoNumber) {
  const nlohmann::json all = reportOf([](SampleStudy& study) { fillCensored(study); });
  const nlohmann::json without = reportOf([](SampleStudy& study) { fillCensored(study, "unwell"); });
  expectHonest(without);
  EXPECT_EQ(valueOfCell(all, "subjects/analysed"), 6);
  EXPECT_EQ(valueOfCell(without, "subjects/analysed"), 5);
  EXPECT_EQ(analysis_.flow.excludedTrials, 10);
  // The last subject is the slowest: 2.5 s in two of five searches.
  const auto mean = [](const nlohmann::json& report) {
    return valueIn(report, "find-survival", "ppc: restricted mean", "Estimate").value_or(NAN);
  };
  EXPECT_NEAR(mean(all), 42 + 2.0 / 5 * 1.25, 1e-9);
  EXPECT_NEAR(mean(without), 42 + 2.0 / 5 * 1.0, 1e-9);
  EXPECT_NEAR(valueOfCell(without, "section-7.4.2/stationary/ppc").value_or(NAN), 16, 1e-9);
  EXPECT_FALSE(elementOf(without, "exclusions").is_null());
}

TEST_F(StudyReport, sharesAreOfAllTrialsOfTheirViewAndSession) {
  int right[2] = {};
  int trials[2] = {};
  MadeStudy made = changed([&](SampleTrial& trial) {
    if (trial.task != "count") {
      return;
    }
    if (trial.caseIndex == 1) {
      // Nobody answered in time: that is not right, and counts.
      trial.censored = true;
      trial.correct = false;
      trial.answer = "";
    }
    if (trial.session == 1 && !*trial.moving) {
      ++trials[trial.view == "gc" ? 1 : 0];
      right[trial.view == "gc" ? 1 : 0] += trial.correct ? 1 : 0;
    }
  });
  made.sessions = 1;
  const nlohmann::json report = reportOf([&](SampleStudy& study) {
    fillWholeStudy(study, made);
    // Of counts of moving objects it is not known whether they are right: they have no share.
    study.database().exec("DROP TRIGGER trial_update; UPDATE trial SET correct = NULL WHERE block = 'count moving'");
  });
  for (const std::string view : {"ppc", "gc"}) {
    const int v = view == "gc" ? 1 : 0;
    const double share = static_cast<double>(right[v]) / trials[v];
    EXPECT_NEAR(valueIn(report, "count-shares", fmt::format("{}, session 1", view), "Estimate").value_or(NAN), share,
                1e-12);
    EXPECT_NEAR(valueOfCell(report, fmt::format("section-7.4.3/stationary/{}", view)).value_or(NAN), 100 * share, 1e-9);
    EXPECT_FALSE(valueOfCell(report, fmt::format("section-7.4.3/moving/{}", view)));
  }
}

TEST_F(StudyReport, answersThatAreNotKnownAreInNoDenominator) {
  const nlohmann::json report = reportOf([](SampleStudy& study) {
    fillWholeStudy(study, changed([](SampleTrial& trial) { trial.correct = trial.task != "count"; }));
    study.database().exec(
        "DROP TRIGGER trial_update; UPDATE trial SET correct = CASE WHEN case_index = 0 THEN 1 ELSE NULL END "
        "WHERE block = 'count stationary' AND case_index < 3");
  });
  // One case is right, two are not known, one is wrong.
  EXPECT_EQ(valueOfCell(report, "section-7.4.3/stationary/gc"), 50);
}

TEST_F(StudyReport, familiesAreCorrectedByHolmsMethodWhereThePlanSaysSo) {
  AnalysisPlan plan = defaultPlan();
  ASSERT_FALSE(plan.families.empty());
  // All hypotheses in one family; then the same without a correction.
  plan.families = {{"all", true, {}}, {"raw", false, {}}};
  for (const Hypothesis& hypothesis : plan.hypotheses) {
    plan.families[0].hypotheses.push_back(hypothesis.name);
    plan.families[1].hypotheses.push_back(hypothesis.name);
  }
  nlohmann::json report = reportOfMade({}, plan);
  expectHonest(report);
  std::vector<std::pair<double, std::string>> tests;
  for (const Hypothesis& hypothesis : plan.hypotheses) {
    const auto p = valueIn(report, "family-all", hypothesis.name, "p");
    ASSERT_TRUE(p) << hypothesis.name;
    EXPECT_EQ(valueIn(report, "family-raw", hypothesis.name, "p"), p);
    EXPECT_EQ(valueIn(report, "family-raw", hypothesis.name, "Adjusted p"), p);
    tests.emplace_back(*p, hypothesis.name);
  }
  ASSERT_GE(tests.size(), 3u);
  std::sort(tests.begin(), tests.end());
  std::vector<double> adjusted;
  size_t maxLifted = 0;
  for (size_t i = 0; i < tests.size(); ++i) {
    adjusted.push_back(
        std::max(i > 0 ? adjusted[i - 1] : 0.0, std::min(1.0, static_cast<double>(tests.size() - i) * tests[i].first)));
    EXPECT_NEAR(valueIn(report, "family-all", tests[i].second, "Adjusted p").value_or(NAN), adjusted[i], 1e-12);
    const bool isLevel = tests[i].first + adjusted[i] < 1;  // half of it is one
    maxLifted = isLevel && adjusted[i] - tests[i].first > adjusted[maxLifted] - tests[maxLifted].first ? i : maxLifted;
  }
  // At a level that the correction lifts one p value above, the corrected one decides.
  plan.alpha = (tests[maxLifted].first + adjusted[maxLifted]) / 2;
  ASSERT_LT(tests[maxLifted].first, plan.alpha);
  report = reportOfMade({}, plan);
  for (const auto& [family, result] :
       {std::pair("family-all", "not supported"), std::pair("family-raw", "supported")}) {
    const nlohmann::json table = elementOf(report, family);
    int rows = 0;
    for (const nlohmann::json& row : table["rows"]) {
      if (row[0]["short_name"] == tests[maxLifted].second) {
        EXPECT_EQ(row.back()["text"], result);
        ++rows;
      }
    }
    EXPECT_EQ(rows, 1) << family;
  }
}

// ---- Where numbers come from.

/// The rows that a cell leads to, through other cells.
std::set<int64_t> rowsBehind(const std::vector<Table>& tables, const std::string& name) {
  const Cell* cell = findCell(tables, name);
  std::set<int64_t> rows;
  if (cell == nullptr) {
    ADD_FAILURE() << "no cell has the name " << name;
    return rows;
  }
  for (const RowRef& row : cell->rows) {
    rows.insert(row.row);
  }
  for (const std::string& part : cell->cells) {
    rows.merge(rowsBehind(tables, part));
  }
  return rows;
}

TEST_F(StudyReport, everyHypothesisTracesToTheTestThatDecidesIt) {
  MadeStudy made;
  made.subjects = 8;
  reportOfMade(made);
  const std::vector<Table>& tables = document_.origins.tables;
  int traced = 0;
  for (const HypothesisFamily& family : analysis_.plan.families) {
    for (const std::string& hypothesis : family.hypotheses) {
      SCOPED_TRACE(hypothesis);
      const Cell* cell = findCell(tables, fmt::format("family-{}/{}/p", family.name, hypothesis));
      ASSERT_NE(cell, nullptr);
      ASSERT_FALSE(cell->cells.empty());
      // The test of the survey is made of several; the others stand as they are.
      const bool isSurvey = hypothesis == "survey-preference";
      EXPECT_EQ(cell->cells.size(), isSurvey ? 3u : 1u);
      bool isThere = false;
      for (const std::string& name : cell->cells) {
        const Cell* test = findCell(tables, name);
        ASSERT_NE(test, nullptr) << name;
        isThere = isThere || (isSurvey ? *test->value <= *cell->value : *test->value == *cell->value);
      }
      EXPECT_TRUE(isThere) << cell->cells.front() << " is not the p value";
      EXPECT_FALSE(rowsBehind(tables, cell->name).empty());
      ++traced;
    }
  }
  EXPECT_EQ(traced, 6);
  EXPECT_THAT(findCell(tables, "family-secondary/find-learning/p")->cells.front(), HasSubstr("view-x-session"));
}

TEST_F(StudyReport, theIntervalOfEquivalenceTracesToItsTrials) {
  const nlohmann::json report = reportOfMade({});
  const Cell* lower = findCell(document_.origins.tables, "path-equivalence/90-interval/lower");
  const Cell* upper = findCell(document_.origins.tables, "path-equivalence/90-interval/upper");
  ASSERT_NE(lower, nullptr);
  ASSERT_NE(upper, nullptr);
  ASSERT_TRUE(lower->value && upper->value);
  EXPECT_LT(*lower->value, *upper->value);
  EXPECT_FALSE(rowsBehind(document_.origins.tables, lower->name).empty());
  const nlohmann::json table = elementOf(report, "path-equivalence");
  EXPECT_EQ(table["rows"][1][1]["id"], lower->name);
}

TEST_F(StudyReport, tablesOfOtherProtocolsAreNotHeadedByThePaper) {
  reportOfMade({});
  const auto headings = [&] {
    std::vector<std::string> texts;
    for (const ReportElement& element : document_.elements) {
      if (const auto* heading = std::get_if<ReportHeading>(&element)) {
        texts.push_back(heading->text);
      }
    }
    return texts;
  };
  EXPECT_THAT(headings(), Contains("The tables of Rosen 2010"));
  analysis_.data.sources[0].protocolName = "mine";
  document_ = studyReport(analysis_, paperTables(analysis_), {{}, "1.2.3"});
  EXPECT_THAT(headings(), Contains("Tables of the study"));
  EXPECT_THAT(headings(), testing::Not(Contains("The tables of Rosen 2010")));
  EXPECT_THAT(jsonReport(document_), testing::Not(HasSubstr("table-7")));
}

TEST_F(StudyReport, aFamilyKeepsItsSizeWhereOneOfItCannotBeTested) {
  const auto withoutPaths = only([](const SampleTrial& trial) { return trial.task != "path"; });
  const nlohmann::json report = reportOfMade(withoutPaths);
  std::vector<double> tests;
  for (const char* hypothesis : {"find-faster", "count-better"}) {
    tests.push_back(valueIn(report, "family-primary", hypothesis, "p").value_or(NAN));
  }
  EXPECT_FALSE(valueIn(report, "family-primary", "path-alike", "p"));
  EXPECT_NEAR(std::min(valueIn(report, "family-primary", "find-faster", "Adjusted p").value_or(NAN),
                       valueIn(report, "family-primary", "count-better", "Adjusted p").value_or(NAN)),
              std::min(1.0, 3 * std::min(tests[0], tests[1])), 1e-12)
      << "three hypotheses were planned";
  EXPECT_THAT(htmlReport(document_), HasSubstr("corrects for all of its 3 hypotheses"));
}

// ---- Data that do not tell.

}  // namespace
}  // namespace ocelli::test
