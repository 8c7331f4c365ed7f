// Tables of other tools give whole reports, with the numbers that the same trials give from elsewhere.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "analysis/dataset/csv_export.h"
#include "analysis/dataset/mapped_trials.h"
#include "analysis/dataset/merge.h"
#include "analysis/report/default_plan.h"
#include "analysis/report/json_report.h"
#include "analysis/report/report_files.h"
#include "analysis/report/report_task.h"
#include "analysis/report/study_report.h"
#include "analysis/tables/paper_tables.h"
#include "study/export/study_export.h"
#include "tests/analysis_dataset/made_study.h"
#include "tests/analysis_report/report_reading.h"

namespace ocelli::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string kExamples = OCELLI_SOURCE_DIR "/analysis/dataset/column_maps/examples/";

struct MappedReport : ::testing::Test {
  nlohmann::json reportOf(Dataset data) {
    AnalysisPlan plan = defaultPlanOf(data);
    plan.bootstrapSamples = 100;
    analysis = applyPlan(merge({std::move(data)}), plan);
    document = studyReport(analysis, paperTables(analysis), {{}, "1.2.3"});
    return nlohmann::json::parse(jsonReport(document));
  }
  nlohmann::json reportOfExample(const std::string& tool) {
    return reportOf(readMappedTables({kExamples + tool + ".csv"}, readColumnMap(kExamples + tool + ".json")));
  }
  /// Values of all cells of tables with names that begin so.
  std::map<std::string, double> cellsOf(const std::string& start) const {
    std::map<std::string, double> cells;
    for (const Table& table : document.origins.tables) {
      for (const TableRow& row : table.rows) {
        for (const Cell& cell : row.cells) {
          if (cell.name.starts_with(start) && cell.value) {
            cells[cell.name] = *cell.value;
          }
        }
      }
    }
    return cells;
  }

  SampleFolder folder;
  AnalysisData analysis;
  ReportDocument document;
};

/// Iterated fits end where they are near enough, and differences of clocks in UXF's table are rounded.
void expectSame(const std::map<std::string, double>& cells, const std::map<std::string, double>& others,
                double tolerance) {
  ASSERT_EQ(cells.size(), others.size());
  for (const auto& [name, value] : cells) {
    const auto other = others.find(name);
    ASSERT_NE(other, others.end()) << name;
    EXPECT_NEAR(value, other->second, tolerance * std::max(1.0, std::abs(value))) << name;
  }
}

TEST_F(MappedReport, eachToolGivesAWholeReportWithTheSameNumbers) {
  std::map<std::string, double> first;
  for (const std::string tool : {"psychopy", "jspsych", "uxf"}) {
    const nlohmann::json report = reportOfExample(tool);
    EXPECT_THAT(document.failures, IsEmpty()) << tool;
    EXPECT_THAT(dishonestNumbers(report), IsEmpty()) << tool;
    EXPECT_EQ(analysis.flow.analysedTrials, 128) << tool;
    EXPECT_EQ(analysis.flow.analysed, 8) << tool;
    EXPECT_EQ(document.marking, "Simulated subjects") << "as the map says";
    for (const ReportFile& file : reportFiles(document)) {
      if (!file.name.ends_with(".pdf")) {
        EXPECT_THAT(numbersThatAreNone(file.bytes), IsEmpty()) << tool << file.name;
      }
    }
    // What was put in is a ratio of 0.7, and an interval of one study holds it.
    const auto ratio = valueIn(report, "task-search-time", "view (graph camera / pinhole)", "Estimate");
    ASSERT_TRUE(ratio) << tool;
    EXPECT_NEAR(*ratio, 0.7, 0.15) << tool;
    // The report begins with it.
    EXPECT_TRUE(valueIn(report, "family-views", "The views differ in times of search", "p")) << tool;
    const std::map<std::string, double> cells = cellsOf("task-search");
    EXPECT_GT(cells.size(), 30u) << tool;
    if (first.empty()) {
      first = cells;
    } else {
      expectSame(cells, first, 1e-6);
    }
  }
}

TEST_F(MappedReport, saysWhatIsNotKnown) {
  ColumnMap map = readColumnMap(kExamples + "uxf.json");
  map.subjects = MappedSubjects::kUnknown;
  const nlohmann::json report = reportOf(readMappedTables({kExamples + "uxf.csv"}, map));
  EXPECT_EQ(document.marking, "Not known: people or simulated");
  const std::string text = report.dump();
  EXPECT_THAT(text, HasSubstr("Nothing says whether these subjects are people or simulated"));
  EXPECT_THAT(text, HasSubstr("Whether subjects were people or simulated is not known. Trials were recorded by UXF."));
  EXPECT_THAT(text, HasSubstr("Such tables do not tell the protocol"));
  EXPECT_THAT(text, HasSubstr("tables do not tell how sessions ended"));
  EXPECT_THAT(text, HasSubstr("tables do not hold consent"));
  EXPECT_THAT(text, HasSubstr("Map of columns"));
  EXPECT_THAT(text, HasSubstr("time: column end_time less start_time, in seconds"));
  EXPECT_THAT(text, Not(HasSubstr("subjects were simulated")));
  const std::vector<ReportFile> files = tableFiles(analysis, document, {{}, "1.2.3"}, true);
  for (const ReportFile& file : files) {
    if (file.name == "tables/trials.csv") {
      const size_t line = file.bytes.find("\r\n") + 2;
      EXPECT_EQ(file.bytes[file.bytes.find("\r\n", line) - 1], ',') << "the column \"simulated\" is empty";
    }
  }
}

TEST_F(MappedReport, peopleAreNotMarked) {
  ColumnMap map = readColumnMap(kExamples + "uxf.json");
  map.subjects = MappedSubjects::kPeople;
  const std::string text = reportOf(readMappedTables({kExamples + "uxf.csv"}, map)).dump();
  EXPECT_EQ(document.marking, "");
  EXPECT_THAT(text, HasSubstr("That the subjects are people is what the map says."));
  EXPECT_THAT(text, Not(HasSubstr("subjects were simulated")));
}

/// Where nothing tells which answers are right, or which trials a limit cut off, no number and no sentence does.
TEST_F(MappedReport, claimsNothingAboutAnswersAndLimitsThatTablesDoNotTell) {
  ColumnMap map = readColumnMap(kExamples + "uxf.json");
  map.correct = {};
  map.answer = {};
  map.timeout = {};
  const nlohmann::json report = reportOf(readMappedTables({kExamples + "uxf.csv"}, map));
  EXPECT_THAT(document.failures, IsEmpty());
  EXPECT_THAT(dishonestNumbers(report), IsEmpty());
  EXPECT_TRUE(valueIn(report, "family-views", "The views differ in times of search", "p"));
  EXPECT_FALSE(valueIn(report, "family-views", "The views differ in right answers of search", "p"));
  EXPECT_THAT(report.dump(), HasSubstr("Whether limits of time cut trials off is not known."));
  EXPECT_THAT(report.dump(), Not(HasSubstr("All answers came in time")));
}

/// More conditions than two have contrasts in place of hypotheses.
TEST_F(MappedReport, aThirdConditionIsComparedToo) {
  const ColumnMap map = columnMapFromJsonText(
      R"({"subject": "who", "condition": "view", "case": "scene", "time": {"column": "t"}, "trial": "n"})", "map.json");
  std::string text = "who,n,view,scene,t\n";
  for (int i = 0; i < 72; ++i) {
    text += fmt::format("S{},{},{},case {},{}\n", i / 12, i % 12, std::string(1, static_cast<char>('a' + i % 3)), i % 4,
                        1 + 0.5 * (i % 3) + 0.1 * ((7 * i) % 11));
  }
  std::ofstream(folder.file("three.csv")) << text;
  const nlohmann::json report = reportOf(readMappedTables({folder.file("three.csv")}, map));
  EXPECT_THAT(document.failures, IsEmpty());
  EXPECT_THAT(report.dump(), HasSubstr("The study has 3 conditions:"));
  // Times are 1, 1.5 and 2 s and the same scatter for all.
  const auto estimate = valueIn(report, "family-task-main-time", "c differs from a", "Estimate");
  ASSERT_TRUE(estimate) << elementOf(report, "family-task-main-time").dump();
  EXPECT_NEAR(*estimate, 1.7, 0.3);
}

/// trials.csv of an export, as any table, with a map of its columns.
TEST_F(MappedReport, givesTheNumbersOfAnExportOfTheSameTrials) {
  MadeStudy made;
  made.change = [](SampleTrial& trial) {
    if (trial.task != "find" || *trial.moving) {
      return false;
    }
    trial.task = "seek";  // one that has no models with terms that tables of other tools lack
    trial.moving.reset();
    trial.objects.reset();
    return true;
  };
  {
    SampleStudy study(folder.file("study.db"), kWholeProtocol);
    fillWholeStudy(study, made);
  }
  exportStudy(folder.file("study.db"), folder.file("tables"), {});
  const ColumnMap map = columnMapFromJsonText(R"({
    "subjects": "people", "rows": [{"column": "counts", "is": ["1"]}], "subject": "subject_id", "session": "session_number",
    "task": "task", "block": "block", "condition": "view", "conditions": [{"value": "ppc"}, {"value": "gc"}],
    "case": "case_label", "trial": "plan_index", "time": {"column": "response_s"}, "answer": "answer",
    "expected": "expected", "correct": {"column": "correct", "right": ["1"], "wrong": ["0"]},
    "timeout": {"column": "censored", "is": ["1"], "limit_seconds": 60}})",
                                              "export.json");
  const Dataset mapped = readMappedTables({folder.file("tables/trials.csv")}, map);
  const Dataset exported = readCsvExport(folder.file("tables"));
  ASSERT_EQ(mapped.trials.size(), exported.trials.size());
  ASSERT_GT(mapped.trials.size(), 90u);
  for (size_t i = 0; i < mapped.trials.size(); ++i) {
    const Trial& one = mapped.trials[i];
    const Trial& other = exported.trials[i];
    EXPECT_EQ(std::tie(one.subject, one.session, one.planIndex, one.caseIndex, one.caseLabel, one.view, one.task),
              std::tie(other.subject, other.session, other.planIndex, other.caseIndex, other.caseLabel, other.view,
                       other.task));
    EXPECT_EQ(std::tie(one.responseSeconds, one.responseTicks, one.censored, one.correct, one.answer, one.expected),
              std::tie(other.responseSeconds, other.responseTicks, other.censored, other.correct, other.answer,
                       other.expected));
  }
  reportOf(exported);
  const std::map<std::string, double> expected = cellsOf("task-seek");
  EXPECT_GT(expected.size(), 30u);
  reportOf(mapped);
  expectSame(cellsOf("task-seek"), expected, 1e-9);
}

}  // namespace
}  // namespace ocelli::test
