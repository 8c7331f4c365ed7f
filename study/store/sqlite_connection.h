// A connection to a study's database, with the settings that make it safe. For .cpp files: it shows SQLiteCpp.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "study/trial/trials_file.h"

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

/// connectSqlite() to a database of a study of this version: an older one is brought up to date, a new one gets its
/// tables. Throws InputError too for a database of another program or of a newer version.
SQLite::Database connectStudy(const std::filesystem::path& path, DatabaseAccess access);

/// NULL for what is missing.
template <class Value>
void bindOptional(SQLite::Statement& statement, int index, const std::optional<Value>& value) {
  if (value) {
    statement.bind(index, *value);
  } else {
    statement.bind(index);
  }
}
std::string textOf(const SQLite::Statement& row, int column);

/// Stores what the study of a new database is, with a line in the audit trail.
void insertStudy(SQLite::Database& database, const std::string& protocolName, const std::string& protocolSha256,
                 const std::string& protocolText);
/// Adds a line to the audit trail. `detail` is JSON and names no subject.
void addAudit(SQLite::Database& database, const std::string& action, const std::string& detailJson);
/// 128 random bits, hexadecimal.
std::string randomKey();

}  // namespace ocelli
