// Comma-separated values as RFC 4180 has them. Other programs separate by semicolons or tabs, too.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

/// A field of a line: in quotes where it holds a comma, a quote or a line break. What a spreadsheet would take for a
/// formula (it begins with =, +, -, @, a tab or a carriage return) gets a ' in front. Bytes that are no UTF-8 become
/// U+FFFD.
std::string csvText(std::string_view text);
/// A field that was read, without the ' that csvText() put in front.
std::string textOfCsv(const std::string& field);

/// Reads row by row. Takes LF and CRLF, and leaves out the byte order mark that spreadsheets write.
class CsvReader {
 public:
  /// `bytes` must outlive it; `where` names the file in messages.
  CsvReader(std::string_view bytes, std::string where, char separator = ',');

  /// The fields of the next row; false at the end. Throws InputError with the line for a quote that does not end.
  bool next(std::vector<std::string>& fields);

  /// "FILE:LINE" of the row that next() gave.
  std::string place() const;
  /// Of its first byte, from 1.
  int64_t line() const { return rowLine_; }

 private:
  std::string_view bytes_;
  std::string where_;
  char separator_;
  int64_t line_ = 1;     ///< of the byte that comes next
  int64_t rowLine_ = 1;  ///< of the row's first byte
};

/// All rows of a table, each as its fields. Throws as CsvReader does.
std::vector<std::vector<std::string>> csvRows(std::string_view bytes, const std::string& where);

}  // namespace ocelli
