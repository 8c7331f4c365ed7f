// Opening a study's database to read it. For .cpp files: it shows SQLiteCpp.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <string>

namespace ocelli {

/// As readDatabase() in database.h says. The connection cannot write.
SQLite::Database openStudyForReading(const std::string& path);

/// Throws InputError where rows that an analysis reads are damaged, or break the rules of the schema.
void checkIntegrity(SQLite::Database& database, const std::string& path);

/// Throws what went wrong as InputError.
[[noreturn]] void throwSqliteError(const SQLite::Exception& error, const std::string& path);

template <class Work>
auto withSqliteErrors(const std::string& path, const Work& work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throwSqliteError(error, path);
  }
}

}  // namespace ocelli
