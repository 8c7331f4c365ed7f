#include "study/trial/trials_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include <string_view>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOurFiles = "the file that `ocelli study run` or `ocelli study simulate` wrote";
constexpr const char* kCopy = "the last backup, or a copy of it; `sqlite3 FILE .recover` saves what can be read";

bool mayWrite(const fs::path& path) {
  return faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
}

}  // namespace

std::string uriForReading(const fs::path& path) {
  std::error_code error;
  fs::path absolute = fs::canonical(path, error);
  absolute = error ? fs::absolute(path) : absolute;
  std::string uri = "file:";
  for (const char c : absolute.string()) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("/-_.~").find(c) != std::string_view::npos;
    uri += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  fs::path log = absolute;
  log += "-wal";
  if (fs::exists(log, error) && fs::file_size(log, error) > 0) {
    return uri + "?mode=ro";
  }
  return uri + (!mayWrite(absolute.parent_path()) ? "?immutable=1" : mayWrite(absolute) ? "?mode=rw" : "?mode=ro");
}

SQLite::Database openForReading(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    throw InputError("there is no such file", path.string(), "check the name; `ocelli study run` makes a new database");
  }
  if (!fs::is_regular_file(path, ignored)) {
    throw InputError("this is no file", path.string(), kOurFiles);
  }
  return withSqliteErrors("open this database", path, [&] {
    // What the address allows is less than what the flags do.
    SQLite::Database database(uriForReading(path), SQLite::OPEN_READWRITE | SQLite::OPEN_URI, kBusyMilliseconds);
    database.exec("PRAGMA query_only = ON; PRAGMA trusted_schema = OFF; PRAGMA temp_store = MEMORY");
    return database;
  });
}

int trialsVersionOf(SQLite::Database& database, const fs::path& path) {
  return withSqliteErrors("open this database", path, [&] {
    if (database.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0) {
      throw InputError("this database is empty", path.string(), kOurFiles);
    }
    if (database.execAndGet("PRAGMA application_id").getInt() != kTrialsApplicationId) {
      throw InputError("this is no database of a study", path.string(), kOurFiles);
    }
    const int version = database.execAndGet("PRAGMA user_version").getInt();
    if (version > kTrialsSchemaVersion) {
      throw InputError(fmt::format("this database has version {} of the schema, and this program knows those up to {}",
                                   version, kTrialsSchemaVersion),
                       path.string(), "a newer version of ocelli");
    }
    return version;
  });
}

SQLite::Database openTrials(const fs::path& path) {
  SQLite::Database database = openForReading(path);
  const int version = trialsVersionOf(database, path);
  if (version < kOldestTrialsSchemaVersion) {
    throw InputError(fmt::format("this database has version {} of the schema, and this program reads those from {}",
                                 version, kOldestTrialsSchemaVersion),
                     path.string(), "`ocelli study subjects --db FILE`, which brings the file up to date");
  }
  return database;
}

void checkIntegrity(SQLite::Database& database, const fs::path& path) {
  whileReading(path, [&] {
    for (const char* table : {"study", "subject", "session", "run", "consent", "answer", "trial"}) {
      const std::string found = database.execAndGet(fmt::format("PRAGMA integrity_check({})", table)).getString();
      if (found != "ok") {
        throw InputError(fmt::format("this database is damaged, or someone changed it (table {}: {})", table, found),
                         path.string(), kCopy);
      }
    }
  });
}

std::string describeSqliteError(const SQLite::Exception& error) {
  switch (error.getErrorCode()) {
    case SQLITE_FULL:
      return "the disk is full: make room on it";
    case SQLITE_READONLY:
      return "the file or its folder is read-only: change the rights";
    case SQLITE_IOERR:
      return fmt::format("the disk fails ({}): check it, and that it is still there and has space",
                         error.getErrorStr());
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another program holds the database: close that program";
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
      return "the file cannot be opened: check the rights to it, and that its folder exists and may be written to";
    case SQLITE_CORRUPT:
      return "the file is damaged: take the last backup, and keep this file";
    default:
      return error.what();
  }
}

void throwReadingError(const SQLite::Exception& error, const fs::path& path) {
  if (error.getErrorCode() == SQLITE_ERROR) {
    throw InputError(fmt::format("this database has other tables than a study ({})", error.what()), path.string(),
                     "check that its tables are those of protocols/trials.schema.sql");
  }
  throwSqliteError(error, "read this database", path);
}

void throwSqliteError(const SQLite::Exception& error, const std::string& doing, const fs::path& path) {
  switch (error.getErrorCode()) {
    case SQLITE_NOTADB:
      throw InputError("this is no database of a study", path.string(), kOurFiles);
    case SQLITE_CORRUPT:
      throw InputError(fmt::format("this database is damaged ({})", error.getErrorStr()), path.string(), kCopy);
    default:
      throw WorkError(fmt::format("cannot {}", doing), path.string(), describeSqliteError(error));
  }
}

}  // namespace ocelli
