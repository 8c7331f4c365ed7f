// Where the numbers of a report come from: kept in the document while its tables are made.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "analysis/report/report_document.h"

namespace ocelli {

/// Rows of `final_trial` or of `final_answer`, or other cells with From::kCells.
struct OriginRows {
  std::vector<RowRef> rows;
  Cell::From from = Cell::From::kTrials;
  std::vector<std::string> cells{};
};

/// The origins of one table of the report.
class OriginTable {
 public:
  /// `numbers` are the cells of each row. Where the document has a table `id` already, this one is ID-2.
  OriginTable(ReportOrigins& all, const std::string& id, const std::string& title, std::vector<std::string> numbers);

  /// Labels and meanings may hold marks of view conditions, which get names here.
  /// Keeps the rows with the first number; the others refer to it. Returns what the names of its cells begin with,
  /// "ID/LABEL", or nothing where no rows are known. Numbers may be kNotKnown.
  std::string addRow(const std::string& label, const std::string& meaning, OriginRows origin, const std::string& unit,
                     const std::vector<double>& numbers);

  /// `meaning` and the rows of the latest row.
  std::string sourceText(const std::string& meaning) const;

  /// Puts the table into the document, unless it is empty.
  void finish();

 private:
  std::string uniqueName(const std::string& label);

  ReportOrigins& all_;
  Table table_;
  std::set<std::string> names_{};
  std::string rows_{};
};

/// "study.db: rows 1-5 9 (6 rows; --explain CELL lists them)", cut where it is long.
std::string rowsText(const std::vector<RowRef>& rows, const std::vector<std::string>& sources,
                     const std::string& cellName);

}  // namespace ocelli
