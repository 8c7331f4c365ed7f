#include "analysis/dataset/sqlite_reading.h"

#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include <filesystem>
#include <string_view>

#include "analysis/dataset/database.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr int kApplicationId = 0x4f63656c;  // "Ocel"
constexpr int kBusyMilliseconds = 10'000;
constexpr const char* kCopy = "a copy of it; or `sqlite3 FILE .recover`, which saves what can be read";
constexpr const char* kOurFiles = "the file that `ocelli study run` or `ocelli study simulate` wrote";

/// A log that holds something is read and left as it is. Where there is none, a connection that may write takes the
/// files away again that it makes for itself. Nothing can be made in a folder that cannot be written: the file is taken
/// for one that nobody changes.
std::string uriForReading(const std::string& path) {
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
  const bool folderIsWritable = access(absolute.parent_path().c_str(), W_OK) == 0;
  const bool fileIsWritable = access(absolute.c_str(), W_OK) == 0;
  return uri + (!folderIsWritable ? "?immutable=1" : fileIsWritable ? "?mode=rw" : "?mode=ro");
}

[[noreturn]] void failToRead(const std::string& what, const std::string& path, const std::string& next) {
  throw InputError(what, path, next);
}

void checkVersion(SQLite::Database& database, const std::string& path) {
  if (database.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0) {
    failToRead("this database is empty", path, kOurFiles);
  }
  if (database.execAndGet("PRAGMA application_id").getInt() != kApplicationId) {
    failToRead("this is no database of a study", path, kOurFiles);
  }
  const int version = database.execAndGet("PRAGMA user_version").getInt();
  if (version > kKnownTrialsSchema) {
    failToRead(fmt::format("this database has version {} of the schema, and this program knows those up to {}", version,
                           kKnownTrialsSchema),
               path, "a newer version of ocelli");
  }
  if (version < kOldestKnownTrialsSchema) {
    failToRead(fmt::format("this database has version {} of the schema, and this program reads those from {}", version,
                           kOldestKnownTrialsSchema),
               path, "`ocelli study subjects --db FILE`, which brings the file up to date");
  }
}

}  // namespace

void throwSqliteError(const SQLite::Exception& error, const std::string& path) {
  switch (error.getErrorCode()) {
    case SQLITE_NOTADB:
      failToRead("this is no database", path, kOurFiles);
    case SQLITE_CORRUPT:
      failToRead(fmt::format("this database is damaged ({})", error.getErrorStr()), path, kCopy);
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw WorkError("another program keeps this database locked", path, "again, when it has ended");
    case SQLITE_CANTOPEN:
    case SQLITE_READONLY:
    case SQLITE_PERM:
      failToRead(
          fmt::format("this database cannot be opened ({})", error.getErrorStr()), path,
          "check the rights; a database with a -wal file beside it needs a folder that can be written: copy both "
          "there");
    case SQLITE_ERROR:
      failToRead(fmt::format("this database has other tables than a study ({})", error.what()), path,
                 "check that its tables are those of protocols/trials.schema.sql");
    default:
      throw WorkError(fmt::format("cannot read this database ({})", error.what()), path,
                      "check the disk; or a copy of the file");
  }
}

void checkIntegrity(SQLite::Database& database, const std::string& path) {
  // Logs of frames and inputs are by far the largest, and are not read here.
  for (const char* table : {"study", "subject", "session", "run", "consent", "answer", "trial"}) {
    const std::string found = database.execAndGet(fmt::format("PRAGMA integrity_check({})", table)).getString();
    if (found != "ok") {
      failToRead(fmt::format("this database is damaged, or someone changed it (table {}: {})", table, found), path,
                 kCopy);
    }
  }
}

SQLite::Database openStudyForReading(const std::string& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    failToRead("there is no such file", path, "check the name");
  }
  if (!fs::is_regular_file(path, ignored)) {
    failToRead("this is no file", path, kOurFiles);
  }
  return withSqliteErrors(path, [&] {
    const std::string uri = uriForReading(path);
    const bool mayWrite = uri.ends_with("?mode=rw");
    SQLite::Database database(uri, SQLite::OPEN_URI | (mayWrite ? SQLite::OPEN_READWRITE : SQLite::OPEN_READONLY),
                              kBusyMilliseconds);
    database.exec("PRAGMA query_only = ON");
    database.exec("PRAGMA trusted_schema = OFF");
    checkVersion(database, path);
    return database;
  });
}

}  // namespace ocelli
