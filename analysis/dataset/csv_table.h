// A table of comma-separated values, row by row (RFC 4180, LF or CRLF).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

class CsvTable {
 public:
  /// Reads the file. Throws AnalysisError where there is none, or its first line names a column twice.
  explicit CsvTable(const std::string& path);

  const std::vector<std::string>& columns() const { return columns_; }
  /// Throws AnalysisError, naming the file, where there is none.
  size_t column(const std::string& name) const;

  /// Goes to the next row; false at the end. Throws AnalysisError, with the line, for a row with too few or too many
  /// fields, or a quote that does not end.
  bool next();

  /// Of the row. Each throws AnalysisError, with line and column, for what is no such value.
  std::string text(size_t column) const;
  std::string name(size_t column) const;  ///< of a subject, a block, ... (trial_check.h)
  int64_t integer(size_t column) const;
  int32_t smallInteger(size_t column) const;
  bool flag(size_t column) const;  ///< 0 or 1
  std::optional<int64_t> optionalInteger(size_t column) const;
  std::optional<bool> optionalFlag(size_t column) const;
  std::optional<double> optionalReal(size_t column) const;
  /// "0x" and digits: 64 bits.
  std::optional<int64_t> optionalHexadecimal(size_t column) const;

  [[noreturn]] void fail(size_t column, const std::string& problem) const;

 private:
  bool readFields();

  std::string path_;
  std::string bytes_;
  size_t at_ = 0;
  int64_t line_ = 1;     ///< of `at_`
  int64_t rowLine_ = 1;  ///< of the row's first byte
  std::vector<std::string> columns_;
  std::vector<std::string> fields_;
};

/// A field as a table holds it: in quotes where it needs them, and with a ' in front where a spreadsheet would take it
/// for a formula.
std::string csvField(std::string_view text);

/// The whole file. Throws AnalysisError.
std::string fileBytes(const std::string& path);

}  // namespace ocelli
