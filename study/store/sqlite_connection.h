// A connection to a study's database, with the settings that make it safe. For .cpp files: it shows SQLiteCpp.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ocelli {

enum class DatabaseAccess {
  kRead,
  kWrite,   ///< an existing one
  kCreate,  ///< made where there is none
};

/// Opens the file: WAL, every commit on the disk before it returns, foreign keys, deleted bytes overwritten. To be read
/// it may be any database. Throws InputError where there is no such file or it is no SQLite database, or is another
/// program's and to be written, which stays as it is; WorkError where it cannot be opened or written.
SQLite::Database connectSqlite(const std::filesystem::path& path, DatabaseAccess access);

/// How to open a database so that reading changes nothing and leaves no file behind: the log of a program that runs or
/// was killed stays as it is; without one, the files that SQLite makes go when it is closed; in a folder that cannot be
/// written none are made.
std::string uriForReading(const std::filesystem::path& path);

/// connectSqlite() to a database of a study of this version: an older one is brought up to date, a new one gets its
/// tables. Throws InputError too for a database of another program or of a newer version.
SQLite::Database connectStudy(const std::filesystem::path& path, DatabaseAccess access);

/// What is thrown for an error of SQLite while doing something ("store a trial") to that file.
[[noreturn]] void throwSqliteError(const SQLite::Exception& error, const std::string& doing,
                                   const std::filesystem::path& path);
/// What SQLite's error means, and what to do about it, in one line.
std::string describeSqliteError(const SQLite::Exception& error);

/// Calls `work()`, turning errors of SQLite into ours.
template <class Work>
auto withSqliteErrors(const std::string& doing, const std::filesystem::path& path, const Work& work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throwSqliteError(error, doing, path);
  }
}

// Values that may be missing.
template <class Value>
void bindOptional(SQLite::Statement& statement, int index, const std::optional<Value>& value) {
  if (value) {
    statement.bind(index, *value);
  } else {
    statement.bind(index);
  }
}
std::string textOf(const SQLite::Statement& row, int column);
std::optional<std::string> optionalTextOf(const SQLite::Statement& row, int column);
std::optional<double> optionalNumberOf(const SQLite::Statement& row, int column);
std::optional<int64_t> optionalIntegerOf(const SQLite::Statement& row, int column);

/// Stores what the study of a new database is, with a line in the audit trail.
void insertStudy(SQLite::Database& database, const std::string& protocolName, const std::string& protocolSha256,
                 const std::string& protocolText);
/// Adds a line to the audit trail. `detail` is JSON and names no subject.
void addAudit(SQLite::Database& database, const std::string& action, const std::string& detailJson);
/// 128 random bits, hexadecimal.
std::string randomKey();

}  // namespace ocelli
