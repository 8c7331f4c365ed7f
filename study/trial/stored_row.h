// The columns of a row of a study's database, read strictly. For .cpp files: it shows SQLiteCpp.
#pragma once

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "study/trial/trial_row.h"
#include "study/trial/trial_words.h"
#include "study/trial/trials_file.h"

namespace ocelli {

/// The columns by the order in which they are asked for. Each throws InputError, naming column and row, for what is no
/// such value.
class StoredRow {
 public:
  /// The first column names the row in messages.
  StoredRow(SQLite::Statement& statement, const std::filesystem::path& path) : statement_(statement), path_(path) {}
  StoredRow(SQLite::Statement& statement, std::filesystem::path&& path) = delete;  // it keeps no path of its own

  /// NULL is empty.
  std::string text();
  int64_t integer();
  /// From 0.
  int smallInteger();
  bool flag() { return smallInteger() != 0; }
  double real();
  std::optional<std::string> optionalText();
  std::optional<int64_t> optionalInteger();
  std::optional<int> optionalSmallInteger();
  std::optional<bool> optionalFlag();
  std::optional<double> optionalReal();
  /// An object of numbers; NULL is an empty one.
  std::map<std::string, double> measures();
  /// A name (problemOfName()).
  std::string name();

  /// One of the words; NULL is an error.
  template <class Word, size_t kCount>
  Word word(const std::array<Word, kCount>& words) {
    const std::string given = text();
    const std::optional<Word> found = wordNamed(given, words);
    if (!found) {
      failAtLast("is \"" + given + "\", but must be one of: " + namesOf(words));
    }
    return *found;
  }
  template <class Word, size_t kCount>
  std::optional<Word> optionalWord(const std::array<Word, kCount>& words) {
    if (isNull()) {
      ++column_;
      return std::nullopt;
    }
    return word(words);
  }

  /// Of the column that was read last.
  [[noreturn]] void failAtLast(const std::string& problem) const;
  [[noreturn]] void fail(const std::string& column, const std::string& problem) const;

 private:
  /// "FILE, trial_id 7".
  std::string place() const;
  SQLite::Column next() { return statement_.getColumn(column_++); }
  bool isNull() const { return statement_.isColumnNull(column_); }

  SQLite::Statement& statement_;
  const std::filesystem::path& path_;
  int column_ = 0;
};

/// Between SELECT and FROM, for readTrial(): of the table `trial` or the view `final_trial`, beside whatever else.
/// `kind` is the expression that has the kind of the subject; columns that tables of that version do not have are NULL.
std::string trialColumns(const std::string& kind, int version = kTrialsSchemaVersion);

/// A trial whose columns come next in the row. It throws as StoredRow does, and for values that no study writes
/// (trial_check.h). `conditions` are those of the protocol.
TrialRow readTrial(StoredRow& row, const ViewConditions& conditions);

}  // namespace ocelli
