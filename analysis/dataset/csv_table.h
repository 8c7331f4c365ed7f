// A table with a head, row by row, whose fields are values of a kind.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/csv.h"
#include "study/trial/trial_words.h"

namespace ocelli {

class CsvTable {
 public:
  /// Reads the file. Throws InputError where there is none, or its first line names a column twice.
  explicit CsvTable(const std::string& path);
  CsvTable(const CsvTable&) = delete;  // its reader reads its bytes
  CsvTable& operator=(const CsvTable&) = delete;

  const std::vector<std::string>& columns() const { return columns_; }
  /// Throws InputError, naming the file, where there is none.
  size_t column(const std::string& name) const;

  /// Goes to the next row; false at the end. Throws InputError, with the line, for a row with too few or too many
  /// fields, or a quote that does not end.
  bool next();

  /// Of the row. Each throws InputError, with line and column, for what is no such value.
  std::string text(size_t column) const;
  std::string name(size_t column) const;  ///< of a subject, a block, ... (study/trial/trial_check.h)
  int64_t integer(size_t column) const;
  int32_t smallInteger(size_t column) const;
  bool flag(size_t column) const;  ///< 0 or 1
  std::optional<int64_t> optionalInteger(size_t column) const;
  std::optional<bool> optionalFlag(size_t column) const;
  std::optional<double> optionalReal(size_t column) const;
  /// "0x" and digits: 64 bits.
  std::optional<uint64_t> optionalHexadecimal(size_t column) const;
  /// One of the words (study/trial/trial_words.h).
  template <class Word, size_t kCount>
  Word word(size_t column, const std::array<Word, kCount>& words) const {
    const std::optional<Word> found = wordNamed(fields_[column], words);
    if (!found) {
      fail(column, "is \"" + fields_[column] + "\", but must be one of: " + namesOf(words));
    }
    return *found;
  }
  template <class Word, size_t kCount>
  std::optional<Word> optionalWord(size_t column, const std::array<Word, kCount>& words) const {
    return fields_[column].empty() ? std::nullopt : std::optional(word(column, words));
  }

  [[noreturn]] void fail(size_t column, const std::string& problem) const;

 private:
  std::string path_;
  std::string bytes_;
  CsvReader reader_;  ///< of `bytes_`
  std::vector<std::string> columns_;
  std::vector<std::string> fields_;
};

}  // namespace ocelli
