#include "analysis/report/json_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/analysis_report/sample_document.h"

namespace ocelli {
namespace {

nlohmann::json tableOf(const nlohmann::json& report, const std::string& label) {
  for (const nlohmann::json& element : report["elements"]) {
    if (element.value("label", "") == label) {
      return element;
    }
  }
  return nullptr;
}

TEST(JsonReport, tablesHaveTheFullValuesAndSourcesOfTheirCells) {
  const nlohmann::json report = nlohmann::json::parse(jsonReport(sampleDocument()));
  EXPECT_EQ(report["format"], kReportFormat);
  const nlohmann::json table = tableOf(report, "Table 1");
  EXPECT_EQ(table["id"], "table-7-1");
  EXPECT_EQ(table["columns"][1]["group"], "Stationary");
  const nlohmann::json cell = table["rows"][0][1];
  EXPECT_EQ(cell["text"], "19.7");
  EXPECT_EQ(cell["value"], 19.7);
  EXPECT_EQ(cell["id"], "t71-s1-ppc");
  EXPECT_EQ(cell["source"], "SELECT avg(response_s) FROM final_trial WHERE task = 'find' AND session = 1");
  // The table has one decimal; this does not.
  EXPECT_DOUBLE_EQ(table["rows"][0][4]["value"].get<double>(), 19.7 * 0.6);
  EXPECT_FALSE(table["rows"][0][0].contains("value"));
}

TEST(JsonReport, cellsNameTheirRowsAndShareSets) {
  ReportDocument document;
  document.origins.sources = {"a.db", "b.db"};
  Cell mean;
  mean.name = "times/mean";
  mean.rows = {{1, 7}, {0, 3}, {0, 1}, {0, 2}, {0, 9}};
  Cell share = mean;
  share.name = "times/share";
  Cell upper;
  upper.name = "times/upper";
  upper.from = Cell::From::kCells;
  upper.cells = {"times/mean"};
  document.origins.tables = {{"times", "Times", {"what"}, {"mean", "share", "upper"}, {{{"x"}, {mean, share, upper}}}}};
  const nlohmann::json report = nlohmann::json::parse(jsonReport(document));
  EXPECT_EQ(report["row_sets"],
            nlohmann::json::parse(R"({"set-1": [{"file": "a.db", "table": "final_trial", "rows": "1-3, 9"},
                                                {"file": "b.db", "table": "final_trial", "rows": "7"}]})"));
  EXPECT_EQ(report["cells"],
            nlohmann::json::parse(R"({"times/mean": {"rows": "set-1"}, "times/share": {"rows": "set-1"},
                                      "times/upper": {"from": ["times/mean"]}})"));
}

TEST(JsonReport, everyElementIsThere) {
  const ReportDocument document = sampleDocument();
  const nlohmann::json report = nlohmann::json::parse(jsonReport(document));
  EXPECT_EQ(report["elements"].size(), document.elements.size());
}

TEST(JsonReport, hostileTextIsValidAndNotANumberIsNull) {
  const nlohmann::json report = nlohmann::json::parse(jsonReport(hostileDocument()));
  const nlohmann::json table = tableOf(report, "Table 1");
  EXPECT_TRUE(table["rows"][1][0]["value"].is_null());
}

}  // namespace
}  // namespace ocelli
