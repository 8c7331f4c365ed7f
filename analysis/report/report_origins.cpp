#include "analysis/report/report_origins.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

constexpr size_t kLongestRowList = 40;

}  // namespace

OriginTable::OriginTable(ReportOrigins& all, const std::string& id, const std::string& title,
                         std::vector<std::string> numbers)
    : all_(all) {
  const auto isTaken = [&](const std::string& name) {
    return std::any_of(all.tables.begin(), all.tables.end(), [&](const Table& table) { return table.name == name; });
  };
  table_.name = id;
  for (int i = 2; isTaken(table_.name); ++i) {
    table_.name = fmt::format("{}-{}", id, i);
  }
  table_.title = withViewNames(title, all.conditions);
  table_.headNames = {"what"};
  table_.cellNames = std::move(numbers);
}

std::string OriginTable::uniqueName(const std::string& label) {
  const std::string part = namePart(label);
  std::string name = fmt::format("{}/{}", table_.name, part);
  for (int i = 2; !names_.insert(name).second; ++i) {
    name = fmt::format("{}/{}-{}", table_.name, part, i);
  }
  return name;
}

std::string OriginTable::addRow(const std::string& markedLabel, const std::string& meaning, OriginRows origin,
                                const std::string& unit, const std::vector<double>& numbers) {
  const std::string label = withViewNames(markedLabel, all_.conditions);
  rows_.clear();
  if (origin.rows.empty() && origin.cells.empty()) {
    return "";
  }
  const std::string name = uniqueName(label);
  TableRow row{{label}, {}};
  for (size_t i = 0; i < numbers.size(); ++i) {
    const std::string& number = table_.cellNames[i];
    Cell cell;
    cell.name = fmt::format("{}/{}", name, number);
    if (std::isfinite(numbers[i])) {
      cell.value = numbers[i];
    }
    cell.missing = "not known";
    cell.decimals = 4;
    cell.meaning = fmt::format("{}, {}: {}", label, number, withViewNames(meaning, all_.conditions));
    cell.unit = number == "p" || number == "statistic" || number == "df" ? "" : unit;
    if (i == 0) {
      cell.from = origin.from;
      cell.rows = std::move(origin.rows);
      cell.cells = std::move(origin.cells);
    } else {
      cell.from = Cell::From::kCells;
      cell.cells = {row.cells.front().name};
    }
    row.cells.push_back(std::move(cell));
  }
  const Cell& first = row.cells.front();
  rows_ = first.from == Cell::From::kCells
              ? fmt::format("from {}", fmt::join(first.cells, ", "))
              : fmt::format("{} of {}", first.from == Cell::From::kTrials ? "final_trial" : "final_answer",
                            rowsText(first.rows, all_.sources, first.name));
  table_.rows.push_back(std::move(row));
  return name;
}

std::string OriginTable::sourceText(const std::string& meaning) const {
  return rows_.empty() ? meaning : fmt::format("{}: {}", meaning, rows_);
}

void OriginTable::finish() {
  if (!table_.rows.empty()) {
    all_.tables.push_back(std::move(table_));
  }
}

std::string rowsText(const std::vector<RowRef>& rows, const std::vector<std::string>& sources,
                     const std::string& cellName) {
  std::vector<RowRef> sorted = rows;
  std::sort(sorted.begin(), sorted.end());
  std::string text;
  int source = -1;
  for (size_t first = 0; first < sorted.size() && text.size() < kLongestRowList;) {
    size_t last = first;
    while (last + 1 < sorted.size() && sorted[last + 1].source == sorted[first].source &&
           sorted[last + 1].row == sorted[last].row + 1) {
      ++last;
    }
    if (sorted[first].source != source) {
      source = sorted[first].source;
      text += fmt::format("{}{}: rows", text.empty() ? "" : "; ", sources[static_cast<size_t>(source)]);
    }
    text += first == last ? fmt::format(" {}", sorted[first].row)
                          : fmt::format(" {}-{}", sorted[first].row, sorted[last].row);
    first = last + 1;
  }
  const bool cut = text.size() >= kLongestRowList;
  return fmt::format("{}{} ({} rows; --explain {} lists them)", text, cut ? " ..." : "", rows.size(), cellName);
}

}  // namespace ocelli
