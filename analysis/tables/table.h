// Tables whose cells know where their numbers come from: what is counted, of how many, and which rows these are.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ocelli {

/// Rows of a cell are those of a source (index into Dataset::sources) and their number there.
struct RowRef {
  int source = 0;
  int64_t row = 0;  ///< `trial_id`, or FormAnswer::answerId

  auto operator<=>(const RowRef&) const = default;
};

struct Cell {
  enum class From : uint8_t {
    kTrials,    ///< `rows` are of final_trial
    kAnswers,   ///< `rows` are of final_answer
    kSubjects,  ///< `subjects` were counted
    kCells,     ///< computed from the cells that `cells` names
    kText,      ///< from the text of the dissertation: published
  };

  std::string name;  ///< "table-7.1/stationary/session-1/bent": no other cell has it
  std::optional<double> value{};
  std::string missing{};  ///< why there is no value: "no trials"
  std::string unit{};     ///< "s", "%" or empty
  int decimals = 1;
  /// Of a share: rows that count, and all rows. Of a mean: nothing, and its rows.
  std::optional<int64_t> numerator{};
  std::optional<int64_t> denominator{};
  std::string meaning{};  ///< "mean time of searches that ended in time": for readers who ask
  From from = From::kTrials;
  std::vector<RowRef> rows{};           ///< of the denominator
  std::vector<std::string> subjects{};  ///< ids
  std::vector<std::string> cells{};

  bool isPublished() const { return from == From::kText; }
};

struct TableRow {
  std::vector<std::string> heads;  ///< as many as Table::headNames
  std::vector<Cell> cells;         ///< as many as Table::cellNames
};

struct Table {
  std::string name;  ///< "table-7.1"
  std::string title;
  std::vector<std::string> headNames;
  std::vector<std::string> cellNames;
  std::vector<TableRow> rows;
  std::vector<std::string> notes{};       ///< whole sentences: conventions, what is not known
  std::vector<std::string> shownNames{};  ///< of the cells' columns for readers, with marks of view conditions; empty:
                                          ///< cellNames
};

/// "12.9 s (n = 300)", "89.6 % (224/250)", "no trials"; a published value without more is "12.9 s".
std::string displayText(const Cell& cell);

/// The table with its title and notes, in columns. Control characters of names are shown as "?".
std::string plainText(const Table& table);

/// All cells, one a line: table, cell, row, column, value, unit, numerator, denominator, published, missing, meaning.
std::string cellsCsv(const std::vector<Table>& tables);

/// nullptr where there is none.
const Cell* findCell(const std::vector<Table>& tables, const std::string& name);

/// A part of a cell's name: small letters, digits, "." and "-" of a text. Never empty.
std::string namePart(const std::string& text);

}  // namespace ocelli
