#include "analysis/tables/neutral_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace ocelli {
namespace {

constexpr const char* kPublishedColumn = "published";
constexpr const char* kSurveyMeans = "survey-means";
constexpr const char* kSubjects = "subjects";

struct NeutralName {
  const char* paper;
  const char* name;
  const char* title;
};
constexpr NeutralName kNeutralNames[] = {
    {"subjects", kSubjects, "Subjects"},
    {"section-7.4.2", "find-means", "Time to find objects"},
    {"time-outs", "time-outs", "Searches whose time ran out"},
    {"table-7.1", "find-by-session", "Time to find objects, by session"},
    {"figure-7.5", "find-by-case", "Time to find objects, by case"},
    {"section-7.4.3", "count-means", "Counts that are right"},
    {"table-7.2-left", "count-by-exposure", "Counts that are right, by exposure"},
    {"table-7.2-right", "count-by-colours", "Counts that are right, by colours"},
    {"table-7.3", "count-by-session", "Counts that are right, by session"},
    {"count-errors", "count-errors", "Counts: objects too many, or too few"},
    {"section-7.4.4", "path-means", "Paths that are recognised"},
    {"section-7.4.5", kSurveyMeans, "Which view was easier, 1 for the @reference@ to 5 for the @other@"},
};

void dropPublished(Table& table) {
  for (TableRow& row : table.rows) {
    std::erase_if(row.cells, [](const Cell& cell) { return cell.isPublished(); });
  }
  std::erase(table.cellNames, kPublishedColumn);
  std::erase(table.shownNames, kPublishedColumn);
}

void rename(Table& table, const NeutralName& neutral, const ViewConditions& conditions) {
  const std::string before = fmt::format("{}/", neutral.paper);
  const std::string after = fmt::format("{}/", neutral.name);
  const auto renamed = [&](std::string& text) {
    for (size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + after.size())) {
      text.replace(at, before.size(), after);
    }
  };
  table.name = neutral.name;
  table.title = withViewLabels(neutral.title, conditions);
  for (TableRow& row : table.rows) {
    for (Cell& cell : row.cells) {
      renamed(cell.name);
      renamed(cell.meaning);  // may tell of other cells
      std::for_each(cell.cells.begin(), cell.cells.end(), renamed);
    }
  }
}

/// Whether it tells of anything: a study need not have all tasks of chapter 7.
bool hasValues(const Table& table) {
  return std::ranges::any_of(table.rows, [](const TableRow& row) {
    return std::ranges::any_of(row.cells, [](const Cell& cell) { return cell.value.has_value(); });
  });
}

}  // namespace

bool isOfRosen2010(const Dataset& data) {
  return data.conditions.hasNamesOf(defaultConditions()) && !data.sources.empty() &&
         std::all_of(data.sources.begin(), data.sources.end(), [](const DataSource& source) {
           return source.protocolName == "rosen2010" || source.protocolName.starts_with("rosen2010-");
         });
}

void makeNeutral(std::vector<Table>& tables, const ViewConditions& conditions) {
  for (Table& table : tables) {
    dropPublished(table);
    const auto* neutral = std::find_if(std::begin(kNeutralNames), std::end(kNeutralNames),
                                       [&](const NeutralName& each) { return table.name == each.paper; });
    if (neutral != std::end(kNeutralNames)) {
      rename(table, *neutral, conditions);
    }
    if (table.name == kSurveyMeans) {
      std::erase_if(table.rows, [](const TableRow& row) { return row.cells.front().rows.empty(); });
    }
  }
  std::erase_if(tables, [](const Table& table) { return table.name != kSubjects && !hasValues(table); });
}

}  // namespace ocelli
