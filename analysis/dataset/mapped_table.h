// A table of another tool, row by row, as a map of columns says to read it. Every error names the file, the line and
// the column.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/column_map.h"
#include "oc_core/base/csv.h"

namespace ocelli {

class MappedTable {
 public:
  /// `map` must outlive it. Throws InputError where the file is missing, empty, not UTF-8, or lacks a column of the
  /// map, or has one of these twice.
  MappedTable(const std::string& path, const ColumnMap& map);
  MappedTable(const MappedTable&) = delete;  // its reader reads its bytes
  MappedTable& operator=(const MappedTable&) = delete;

  /// Goes to the next row that is not blank; false at the end. Throws InputError for one with too few or too many
  /// fields, or with a quote that does not end.
  bool next();
  /// Of the row's first byte, from 1: what a text editor shows, and what stands for the row in a report.
  int64_t line() const { return reader_.line(); }
  /// All fields.
  const std::vector<std::string>& fields() const { return fields_; }

  /// The field as it stands. Throws InputError for what is no UTF-8, holds a control character, or is longer than any
  /// name or answer.
  std::string field(const std::string& column) const;
  /// Empty where the text is not set.
  std::string text(const MappedText& text) const;
  /// Not empty.
  std::string name(const MappedText& text) const;
  bool passes(const RowTest& test) const;
  /// Nothing where the field is one of the texts that stand for none: "", "null", "None", "NA", "N/A", "NaN".
  std::optional<double> number(const std::string& column) const;
  /// From `min` to the largest that a number of trials may be.
  int wholeNumber(const MappedText& text, int min) const;

  [[noreturn]] void fail(const std::string& column, const std::string& problem, const std::string& next = "") const;
  [[noreturn]] void fail(const MappedText& text, const std::string& problem, const std::string& next = "") const;

 private:
  void readColumns();
  void findColumns();
  void checkNoTwoOf(const std::string& column) const;

  std::string path_;
  std::string fileName_;  ///< without folder and ending
  const ColumnMap& map_;
  std::string bytes_;
  CsvReader reader_;  ///< of `bytes_`
  std::vector<std::string> columns_{};
  std::map<std::string, size_t> indices_{};  ///< of the map's columns that the table has
  std::vector<std::string> fields_{};
};

}  // namespace ocelli
