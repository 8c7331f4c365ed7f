#include "analysis/report/paper_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/tables/neutral_tables.h"

namespace ocelli {
namespace {

std::string sourceOf(const Cell& cell, const std::vector<std::string>& sources) {
  switch (cell.from) {
    case Cell::From::kTrials:
      return fmt::format("{}: final_trial of {}", cell.meaning, rowsText(cell.rows, sources, cell.name));
    case Cell::From::kAnswers:
      return fmt::format("{}: final_answer of {}", cell.meaning, rowsText(cell.rows, sources, cell.name));
    case Cell::From::kSubjects:
      return fmt::format("{}: {} subjects; --explain {} lists them", cell.meaning, cell.subjects.size(), cell.name);
    case Cell::From::kCells:
      return fmt::format("{}: from the cells {}", cell.meaning, fmt::join(cell.cells, ", "));
    case Cell::From::kText:
      break;
  }
  return "P. Rosen, Improved 3-D Scene Sampling by Camera Model Design, 2010, chapter 7";
}

}  // namespace

void addPaperSection(ReportWork& work, const std::vector<Table>& tables) {
  const bool isOfPaper = isOfRosen2010(work.analysis.data);
  addHeading(work.document, 1, isOfPaper ? "The tables of Rosen 2010" : "Tables of the study", "paper");
  for (const Table& table : tables) {
    ReportTable shown{table.title, table.name, {}, {}};
    for (const std::string& head : table.headNames) {
      shown.columns.push_back({head, "", true});
    }
    for (const std::string& name : table.shownNames.empty() ? table.cellNames : table.shownNames) {
      shown.columns.push_back({name});
    }
    for (const TableRow& row : table.rows) {
      std::vector<ReportCell> cells;
      for (const std::string& head : row.heads) {
        cells.push_back({head});
      }
      for (const Cell& cell : row.cells) {
        cells.push_back({displayText(cell), cell.name, sourceOf(cell, work.document.origins.sources), cell.value});
      }
      shown.rows.push_back(cells);
    }
    work.document.add(shown);
    work.document.origins.tables.push_back(table);
    for (const std::string& note : table.notes) {
      work.document.add(ReportParagraph{note});
    }
  }
}

}  // namespace ocelli
