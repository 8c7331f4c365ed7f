// A study whose view conditions have other names gives the same numbers, and its report knows no other names.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "analysis/dataset/database.h"
#include "analysis/dataset/merge.h"
#include "analysis/report/report_files.h"
#include "analysis/report/report_task.h"
#include "analysis/report/study_report.h"
#include "analysis/tables/explain.h"
#include "analysis/tables/paper_tables.h"
#include "tests/analysis_dataset/made_study.h"

namespace ocelli::test {
namespace {

using ::testing::HasSubstr;

// One name is a word of English, which stands in many sentences and must stay there.
constexpr const char* kConditions =
    R"({"conditions": [{"name": "flat", "label": "flat view", "view": {"camera": "ppc"}},
                       {"name": "on", "label": "bent view", "view": {"camera": "gc"}}],)";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

std::string otherProtocol() {
  std::string text = replaced(kWholeProtocol, R"(["ppc", "gc"])", R"(["flat", "on"])");
  return text.replace(text.find('{'), 1, kConditions);
}

struct MadeReport {
  AnalysisData analysis;
  ReportDocument document;
  std::vector<Table> tables;
};

class OtherConditions : public testing::Test {
 protected:
  MadeReport reportOf(const std::string& name, const std::string& protocol, const MadeStudy& made) const {
    const std::string path = folder_.file(name);
    {
      SampleStudy study(path, protocol);
      fillWholeStudy(study, made);
    }
    Dataset data = merge({readDatabase(path)});
    AnalysisPlan plan = defaultPlan(data.conditions);
    plan.bootstrapSamples = 100;
    MadeReport made_;
    made_.analysis = applyPlan(std::move(data), plan);
    made_.tables = paperTables(made_.analysis);
    made_.document = studyReport(made_.analysis, made_.tables, {{}, "1.2.3"});
    return made_;
  }
  MadeReport otherReport() const {
    MadeStudy made;
    made.change = [](SampleTrial& trial) {
      trial.view = trial.view == "ppc" ? "flat" : "on";
      return true;
    };
    return reportOf("other.db", otherProtocol(), made);
  }

  SampleFolder folder_;
};

/// By the names that they have where conditions are "flat" and "on".
std::map<std::string, std::optional<double>> cellsOf(const std::vector<Table>& tables) {
  static const std::regex kReference("\\bppc\\b");
  static const std::regex kOther("\\bgc\\b");
  std::map<std::string, std::optional<double>> cells;
  for (const Table& table : tables) {
    for (const TableRow& row : table.rows) {
      for (const Cell& cell : row.cells) {
        cells[std::regex_replace(std::regex_replace(cell.name, kReference, "flat"), kOther, "on")] = cell.value;
      }
    }
  }
  return cells;
}

TEST_F(OtherConditions, giveTheSameNumbersWhateverTheirNames) {
  const MadeReport usual = reportOf("usual.db", kWholeProtocol, {});
  const MadeReport other = otherReport();
  const auto found = cellsOf(other.document.origins.tables);
  const auto published = cellsOf(usual.tables);  // tables of the text have other names for other conditions
  size_t compared = 0;
  for (const auto& [name, value] : cellsOf(usual.document.origins.tables)) {
    if (!published.contains(name)) {
      ASSERT_TRUE(found.contains(name)) << name;
      EXPECT_EQ(found.at(name), value) << name;
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000u);
  EXPECT_EQ(other.document.failures, std::vector<std::string>());
  EXPECT_TRUE(found.contains("find-time/view-on-flat/estimate"));
  EXPECT_TRUE(found.contains("find-means/stationary/on"));
}

TEST_F(OtherConditions, areCalledByTheirOwnNamesAlone) {
  const MadeReport other = otherReport();
  std::vector<ReportFile> files = reportFiles(other.document);
  for (const ReportFile& file : tableFiles(other.analysis, other.document, {{}, "1.2.3"}, true)) {
    files.push_back(file);
  }
  const std::regex names("\\b(ppc|gc|pinholes?|graph camera|reference@|@other)\\b");
  for (const ReportFile& file : files) {
    std::smatch match;
    if (!file.name.ends_with(".pdf")) {
      EXPECT_FALSE(std::regex_search(file.bytes, match, names))
          << file.name << ": " << match.prefix().str().substr(std::max<size_t>(match.prefix().length(), 60) - 60)
          << match.str();
    }
  }
  const std::string& page = files.front().bytes;
  EXPECT_EQ(files.front().name, "index.html");
  EXPECT_THAT(page, HasSubstr("Two views are compared: flat view, and bent view."));
  EXPECT_THAT(page, HasSubstr("Objects are found in another time with the bent view than with the flat view"));
  EXPECT_THAT(page, HasSubstr("Bent view less flat view: difference of restricted means"));
  EXPECT_THAT(explainCell(other.tables, other.analysis.data, "find-means/stationary/on"),
              HasSubstr("find stationary/location 1  on  "));
}

}  // namespace
}  // namespace ocelli::test
