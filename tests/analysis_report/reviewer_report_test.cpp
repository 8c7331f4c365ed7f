// What a reviewer looks for in a report: answers first, with effects; test statistics; what is exploratory; words for
// people; the same digits everywhere; and what only a checker needs apart from it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "analysis/dataset/database.h"
#include "analysis/dataset/merge.h"
#include "analysis/report/html_report.h"
#include "analysis/report/json_report.h"
#include "analysis/report/pdf_report.h"
#include "analysis/report/report_task.h"
#include "analysis/report/study_report.h"
#include "analysis/tables/paper_tables.h"
#include "tests/analysis_dataset/made_study.h"
#include "tests/analysis_report/report_reading.h"

namespace ocelli::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::Not;

AnalysisPlan quickPlan(bool registered) {
  AnalysisPlan plan = defaultPlan();
  plan.bootstrapSamples = 100;
  plan.name = registered ? "maze" : "";
  plan.registered = registered ? "osf.io, 2026" : "";
  return plan;
}

ReportDocument documentOf(bool registered) {
  SampleFolder folder;
  const std::string path = folder.file("study.db");
  SampleStudy study(path, kWholeProtocol);
  fillWholeStudy(study);
  const AnalysisData analysis = applyPlan(merge({readDatabase(path)}), quickPlan(registered));
  return studyReport(analysis, paperTables(analysis), {{}, "1.2.3"});
}

/// Of a study with a plan and of one without, made once.
class ReviewerReport : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    planned() = documentOf(true);
    unplanned() = documentOf(false);
  }
  static ReportDocument& planned() {
    static ReportDocument document;
    return document;
  }
  static ReportDocument& unplanned() {
    static ReportDocument document;
    return document;
  }
  static Json jsonOf(const ReportDocument& document) { return Json::parse(jsonReport(document)); }
};

size_t placeOf(const Json& report, const std::string& id) {
  const Json& elements = report["elements"];
  for (size_t i = 0; i < elements.size(); ++i) {
    if (elements[i].value("id", "") == id) {
      return i;
    }
  }
  ADD_FAILURE() << "nothing has the id " << id;
  return elements.size();
}

Json cellOf(const Json& report, const std::string& table, const std::string& row, const std::string& column) {
  const Json element = elementOf(report, table);
  for (const Json& cells : element["rows"]) {
    for (size_t i = 0; i < cells.size(); ++i) {
      if (cells[0].value("short_name", cells[0]["text"].get<std::string>()) == row &&
          element["columns"][i]["title"] == column) {
        return cells[i];
      }
    }
  }
  ADD_FAILURE() << table << " has no " << row << ", " << column;
  return {};
}

TEST_F(ReviewerReport, answersStandBeforeTheDesignWithEffectAndInterval) {
  const Json report = jsonOf(planned());
  EXPECT_EQ(placeOf(report, "hypotheses"), 0U);
  EXPECT_LT(placeOf(report, "family-primary"), placeOf(report, "design"));
  EXPECT_LT(placeOf(report, "family-secondary"), placeOf(report, "design"));
  const Json estimate = cellOf(report, "family-primary", "find-faster", "Estimate");
  EXPECT_EQ(estimate["value"], valueIn(report, "find-time", "view", "Estimate").value_or(NAN));
  const Json interval = cellOf(report, "family-primary", "find-faster", "95 % interval");
  EXPECT_LT(interval["interval"][0], estimate["value"]);
  EXPECT_GT(interval["interval"][1], estimate["value"]);
  EXPECT_EQ(cellOf(report, "family-primary", "find-faster", "Effect")["text"],
            "Ratio of times, graph camera / pinhole");
  EXPECT_EQ(cellOf(report, "family-primary", "count-better", "Effect")["text"], "Odds ratio, graph camera / pinhole");
  EXPECT_THAT(cellOf(report, "family-primary", "path-alike", "Effect")["text"].get<std::string>(),
              HasSubstr("Difference of shares"));
  EXPECT_THAT(cellOf(report, "family-primary", "path-alike", "95 % interval")["footnote"].get<std::string>(),
              HasSubstr("Interval of 90 %"));
  // In words too: statement, result, effect.
  const std::string answer = report["elements"][2]["items"][0];
  EXPECT_THAT(answer, HasSubstr("with the graph camera than with the pinhole: "));
  EXPECT_THAT(answer, HasSubstr(fmt::format("Ratio of times, graph camera / pinhole: {} (95 % interval {})",
                                            estimate["text"].get<std::string>(), interval["text"].get<std::string>())));
}

TEST_F(ReviewerReport, answersStandOnTheFirstPage) {
  const PdfDocument pdf = pdfPages(planned());
  std::string first;
  for (const Shape& shape : pdf.pages[0].drawing.shapes()) {
    if (const auto* text = std::get_if<TextShape>(&shape.what)) {
      first += text->text + " ";
    }
  }
  for (const char* text : {"What was found", "Family primary", "Odds ratio", "path-alike"}) {
    EXPECT_THAT(first, HasSubstr(text));
  }
}

TEST_F(ReviewerReport, estimatesHaveStandardErrorStatisticAndDegreesOfFreedom) {
  const Json report = jsonOf(planned());
  for (const char* table : {"find-time", "count-right", "path-right", "find-hazard"}) {
    const double ratio = valueIn(report, table, "view", "Estimate").value_or(NAN);
    const double error = valueIn(report, table, "view", "SE").value_or(NAN);
    const double statistic = valueIn(report, table, "view", "Statistic").value_or(NAN);
    // By the delta method, of the logarithm that is tested.
    EXPECT_NEAR(statistic, std::log(ratio) / (error / ratio), 1e-6 * std::abs(statistic)) << table;
    EXPECT_GT(valueIn(report, table, "view", "df").value_or(NAN), 0) << table;
  }
  EXPECT_TRUE(valueOfCell(report, "find-time/view-gc-ppc/df"));
  EXPECT_TRUE(valueIn(report, "learning-find-times", "Session 1", "Statistic (df)"));
  EXPECT_THAT(cellOf(report, "find-time", "view (graph camera / pinhole)", "Statistic")["text"].get<std::string>(),
              testing::StartsWith("t = "));
}

bool isMarked(const Json& report, const std::string& id) {
  return elementOf(report, id).value("exploratory", false);
}

TEST_F(ReviewerReport, tablesOutsideOfTheRegisteredPlanAreExploratory) {
  const Json report = jsonOf(planned());
  for (const char* id : {"find-time", "count-right", "path-equivalence", "family-primary", "family-secondary"}) {
    EXPECT_FALSE(isMarked(report, id)) << id;
  }
  for (const char* id : {"find-time-sensitivity", "find-time-resampled", "find-time-sizes", "count-shares",
                         "learning-find-times", "survey-answers", "table-7-1"}) {
    EXPECT_TRUE(isMarked(report, id)) << id;
  }
  for (const char* id : {"screens", "dropped-frames"}) {
    EXPECT_FALSE(isMarked(report, id)) << id << " is a record";
  }
}

TEST_F(ReviewerReport, withoutAPlanAllResultsAreExploratory) {
  const Json report = jsonOf(unplanned());
  int tables = 0;
  for (const Json& element : report["elements"]) {
    const std::string id = element.value("id", "");
    if (element["type"] == "table" && id != "screens" && !id.starts_with("dropped-frames")) {
      EXPECT_TRUE(element.value("exploratory", false)) << id;
      ++tables;
    }
  }
  EXPECT_GT(tables, 20);
  EXPECT_THAT(htmlReport(unplanned()), HasSubstr("No plan was registered"));
}

TEST_F(ReviewerReport, whatACheckerNeedsStandsInTheSupplement) {
  const Json report = jsonOf(planned());
  for (const char* id :
       {"provenance", "find-time-sensitivity-cases", "figure-find-time-residuals", "dropped-frames-by-subject"}) {
    EXPECT_EQ(elementOf(report, id).value("part", ""), "supplement") << id;
  }
  for (const char* id : {"find-time", "find-time-sensitivity", "apparatus", "methods"}) {
    EXPECT_EQ(elementOf(report, id).value("part", ""), "") << id;
  }
  const std::string main = htmlReport(planned());
  EXPECT_THAT(main, Not(HasSubstr("SHA-256")));
  EXPECT_THAT(main, Not(HasSubstr("Without find stationary")));
  EXPECT_THAT(main, HasSubstr("supplement.html#sources-find-time"));
  EXPECT_THAT(htmlSupplement(planned()), HasSubstr("Without find stationary"));
}

/// All that readers read.
void forEachText(const Json& element, const auto& see) {
  for (const char* field : {"text", "title", "caption", "description"}) {
    if (element.contains(field) && element[field].is_string()) {
      see(element[field].get<std::string>());
    }
  }
  for (const Json& item : element.value("items", Json::array())) {
    see(item.get<std::string>());
  }
  for (const Json& column : element.value("columns", Json::array())) {
    see(column["title"].get<std::string>());
  }
  for (const Json& row : element.value("rows", Json::array())) {
    for (const Json& cell : row) {
      see(cell["text"].get<std::string>());
    }
  }
}

TEST_F(ReviewerReport, readersGetWordsNotShortNames) {
  const std::regex shortName("\\b(ppc|gc|easier_[a-z]+)\\b");
  for (const ReportDocument* document : {&planned(), &unplanned()}) {
    const Json report = jsonOf(*document);
    for (const Json& element : report["elements"]) {
      forEachText(element, [&](const std::string& text) {
        EXPECT_FALSE(std::regex_search(text, shortName)) << element.value("id", "") << ": " << text;
      });
    }
  }
  const Json report = jsonOf(planned());
  EXPECT_EQ(cellOf(report, "survey-answers", "easier_find", "Question")["text"], "To find the object");
}

size_t decimalsOf(const std::string& number) {
  const size_t point = number.find('.');
  return point == std::string::npos ? 0 : number.find_last_of("0123456789") - point;
}

TEST_F(ReviewerReport, estimatesAndBoundsShareTheirDecimals) {
  const std::regex kInterval("(-?[0-9.]+) to (-?[0-9.]+)");
  const std::regex kPValue("< 0\\.001|[01]\\.[0-9]{3}|-");
  int compared = 0;
  const Json report = jsonOf(planned());
  for (const Json& table : report["elements"]) {
    for (const Json& row : table.value("rows", Json::array())) {
      for (size_t i = 0; i < row.size(); ++i) {
        const std::string text = row[i]["text"];
        const std::string title = table["columns"][i]["title"];
        std::smatch bounds;
        if (title == "95 % interval" && std::regex_match(text, bounds, kInterval)) {
          const std::string estimate = row[i - 1]["text"];
          EXPECT_EQ(decimalsOf(bounds[1]), decimalsOf(bounds[2])) << text;
          EXPECT_EQ(decimalsOf(estimate.substr(0, estimate.find(' '))), decimalsOf(bounds[1]))
              << estimate << ", " << text;
          EXPECT_TRUE(row[i].contains("interval")) << "with all digits";
          ++compared;
        }
        if (title == "p" || title == "Adjusted p") {
          EXPECT_TRUE(std::regex_match(text, kPValue)) << text;
        }
      }
    }
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace ocelli::test
