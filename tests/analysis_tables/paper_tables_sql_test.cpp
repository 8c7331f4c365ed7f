// scripts/rosen2010_tables.sql computes the same tables in SQL: each of its numbers must stand in a cell.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "analysis/dataset/merge.h"
#include "analysis/tables/paper_tables.h"
#include "study/protocol/protocol.h"
#include "study/subject/simulate_study.h"
#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

/// The statements after each ".print --- TITLE".
std::map<std::string, std::string> statements() {
  std::ifstream file(OCELLI_SOURCE_DIR "/scripts/rosen2010_tables.sql");
  std::map<std::string, std::string> queries;
  std::string title;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(".print ---")) {
      title = line.substr(11);
    } else if (!line.starts_with('.') && !line.starts_with("--") && !title.empty()) {
      queries[title] += line + "\n";
    }
  }
  return queries;
}

struct SqlTables : ::testing::Test {
  void SetUp() override {
    SimulationPlan plan;
    plan.sessions = {3, 3, 3, 1, 1};
    plan.seed = 5;
    plan.kind = SubjectKind::kGenerator;
    simulateStudy(readProtocol(OCELLI_SOURCE_DIR "/protocols/rosen2010.json"), path, plan);
    AnalysisPlan noExclusions;  // the SQL has none
    noExclusions.usesProtocolExclusions = false;
    tables = paperTables(applyPlan(merge({readSource(path)}), noExclusions));
  }
  /// Compares a column of the SQL, which rounds, with the cell; `perRow` makes the cell's name of a row.
  void compare(const std::string& title, const std::string& column, const auto& cellName, double rounding) {
    const std::map<std::string, std::string> all = statements();
    const auto query = std::find_if(all.begin(), all.end(), [&](const auto& q) { return q.first.starts_with(title); });
    ASSERT_NE(query, all.end()) << title;
    SQLite::Database database(path, SQLite::OPEN_READONLY);
    SQLite::Statement row(database, query->second);
    int rows = 0;
    for (; row.executeStep(); ++rows) {
      const std::string name = cellName(row);
      const Cell* cell = findCell(tables, name);
      ASSERT_NE(cell, nullptr) << name;
      const SQLite::Column value = row.getColumn(column.c_str());
      ASSERT_EQ(cell->value.has_value(), !value.isNull()) << name;
      if (cell->value) {
        // Half of the last digit that the SQL keeps.
        EXPECT_NEAR(*cell->value, value.getDouble(), rounding / 2 + 1e-9) << name;
      }
    }
    EXPECT_GT(rows, 0) << title;
  }

  SampleFolder folder;
  std::string path = folder.file("generated.db");
  std::vector<Table> tables;
};

std::string text(SQLite::Statement& row, const char* column) {
  return row.getColumn(column).getString();
}

TEST_F(SqlTables, holdTheSameNumbers) {
  const std::string views[] = {"ppc", "gc"};
  const auto byObjectsAndView = [](const std::string& table) {
    return [table](SQLite::Statement& row) {
      return fmt::format("{}/{}/{}", table, text(row, "objects"), text(row, "view"));
    };
  };
  compare("Section 7.4.2", "found_s", byObjectsAndView("section-7.4.2"), 0.1);
  compare("Section 7.4.2", "time_over_percent", byObjectsAndView("time-outs"), 0.1);
  for (const std::string& view : views) {
    const auto bySession = [&](const std::string& table) {
      return [&view, table](SQLite::Statement& row) {
        return fmt::format("{}/{}/session-{}/{}", table, text(row, "objects"), text(row, "session"), view);
      };
    };
    compare("Table 7.1", view + "_s", bySession("table-7.1"), 0.1);
    compare("Table 7.3", view, bySession("table-7.3"), 0.1);
    const auto byLocation = [&](SQLite::Statement& row) {
      return fmt::format("figure-7.5/stationary/{}/{}", namePart(text(row, "location")), view);
    };
    compare("Figure 7.5", view + "_s", byLocation, 0.1);
    compare(
        "Figure 7.5", view + "_over_percent", [&](SQLite::Statement& row) { return byLocation(row) + "/time-over"; },
        1);
    compare(
        "Section 7.4.3 and Table 7.2", view,
        [&](SQLite::Statement& row) {
          const std::string condition = text(row, "condition");
          const std::string objects = text(row, "objects");
          return condition == "all" ? fmt::format("section-7.4.3/{}/{}", objects, view)
                 : condition.ends_with("s") && condition.size() <= 4
                     ? fmt::format("table-7.2-left/{}/{}/{}", objects, namePart(condition), view)
                     : fmt::format("table-7.2-right/{}/{}/{}", objects, condition.substr(0, condition.find(' ')), view);
        },
        0.1);
    compare(
        "Section 7.4.4", view,
        [&](SQLite::Statement& row) {
          return text(row, "who") == "all, first session"
                     ? fmt::format("section-7.4.4/all/{}", view)
                     : fmt::format("section-7.4.4/session-{}/{}", text(row, "session"), view);
        },
        0.1);
  }
  compare(
      "Section 7.4.5", "mean", [](SQLite::Statement& row) { return "section-7.4.5/" + namePart(text(row, "field")); },
      0.01);
}

/// What the text reports must be the same in the SQL and here.
TEST_F(SqlTables, holdTheSamePublishedValues) {
  for (const std::string view : {"ppc", "gc"}) {
    const std::string column = "text_" + view;
    compare(
        "Table 7.1", column + "_s",
        [&](SQLite::Statement& row) {
          return fmt::format("table-7.1/{}/session-{}/{}/published", text(row, "objects"), text(row, "session"), view);
        },
        0);
    compare(
        "Table 7.3", column,
        [&](SQLite::Statement& row) {
          return fmt::format("table-7.3/{}/session-{}/{}/published", text(row, "objects"), text(row, "session"), view);
        },
        0);
  }
  compare(
      "Section 7.4.2", "text_s",
      [](SQLite::Statement& row) {
        return fmt::format("section-7.4.2/{}/{}/published", text(row, "objects"), text(row, "view"));
      },
      0);
}

}  // namespace
}  // namespace ocelli::test
