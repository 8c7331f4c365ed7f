#include "study/store/sqlite_connection.h"

#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <random>

#include "oc_core/base/error.h"
#include "oc_core/base/machine.h"
#include "study/session/utc_time.h"
#include "study/store/database_lock.h"
#include "study/store/migrations.h"
#include "study/store/program_version.h"
#include "study/store/trials_schema.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

int openFlags(DatabaseAccess access) {
  const int flags = SQLite::OPEN_READWRITE | SQLite::OPEN_URI;
  return access == DatabaseAccess::kCreate ? flags | SQLite::OPEN_CREATE : flags;
}

bool hasTables(SQLite::Database& database) {
  return database.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() > 0;
}

bool isOfAStudy(SQLite::Database& database) {
  return database.execAndGet("PRAGMA application_id").getInt() == kTrialsApplicationId;
}

[[noreturn]] void throwNotOurs(const fs::path& path) {
  throw InputError("this is no database of a study", path.string(),
                   "the file that `ocelli study run` or `ocelli study simulate` wrote, or a name that is not taken");
}

}  // namespace

SQLite::Database connectSqlite(const fs::path& path, DatabaseAccess access) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    throw InputError("this is a folder, not a database", path.string(), "the name of a file");
  }
  if (access == DatabaseAccess::kRead) {
    return openForReading(path);
  }
  if (access != DatabaseAccess::kCreate && !fs::exists(path, ignored)) {
    throw InputError("there is no such database", path.string(),
                     "check the name; `ocelli study run` makes a new database");
  }
  return withSqliteErrors("open this database", path, [&] {
    // An absolute path is never one of SQLite's special names.
    SQLite::Database database(fs::absolute(path).string(), openFlags(access), kBusyMilliseconds);
    if (sqlite3_db_readonly(database.getHandle(), "main") == 1) {
      throw WorkError("this database cannot be written: its file or folder is read-only", path.string(),
                      "change the rights, or copy the file to a folder that you may write to");
    }
    database.exec("PRAGMA foreign_keys = ON; PRAGMA recursive_triggers = ON; PRAGMA temp_store = MEMORY");
    // Reads the file, and so finds out whether it is a database at all, before anything is changed.
    if (!isOfAStudy(database) && (access != DatabaseAccess::kCreate || hasTables(database))) {
      throwNotOurs(path);
    }
    const std::string mode = database.execAndGet("PRAGMA journal_mode = WAL").getString();
    if (mode != "wal") {
      throw WorkError("this file system cannot hold the log of a database (mode \"" + mode + "\")", path.string(),
                      "a folder on a local disk");
    }
    database.exec("PRAGMA synchronous = FULL; PRAGMA secure_delete = ON");
    return database;
  });
}

SQLite::Database connectStudy(const fs::path& path, DatabaseAccess access) {
  SQLite::Database database = connectSqlite(path, access);
  return withSqliteErrors("open this database", path, [&] {
    if (access == DatabaseAccess::kCreate && !hasTables(database)) {
      SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
      // Another program may have been faster.
      if (!hasTables(database)) {
        database.exec(trialsSchema());
      }
      transaction.commit();
    }
    if (trialsVersionOf(database, path) < kTrialsSchemaVersion) {
      if (access == DatabaseAccess::kRead) {
        SQLite::Database writable = connectSqlite(path, DatabaseAccess::kWrite);
        migrate(writable, migrations(), kTrialsSchemaVersion, path);
      } else {
        migrate(database, migrations(), kTrialsSchemaVersion, path);
      }
    }
    return std::move(database);
  });
}

std::string textOf(const SQLite::Statement& row, int column) {
  return row.getColumn(column).getString();
}

void insertStudy(SQLite::Database& database, const std::string& protocolName, const std::string& protocolSha256,
                 const std::string& protocolText) {
  SQLite::Statement insert(database,
                           "INSERT INTO study (study_id, protocol_name, protocol_sha256, protocol_text, "
                           "program_version, created_utc) VALUES (1, ?, ?, ?, ?, ?)");
  insert.bind(1, protocolName);
  insert.bind(2, protocolSha256);
  insert.bind(3, protocolText);
  insert.bind(4, programVersion());
  insert.bind(5, utcNow());
  insert.exec();
  addAudit(database, "created", "{}");
}

void addAudit(SQLite::Database& database, const std::string& action, const std::string& detailJson) {
  SQLite::Statement insert(database,
                           "INSERT INTO audit (at_utc, action, detail_json, program_version, station) "
                           "VALUES (?, ?, ?, ?, ?)");
  insert.bind(1, utcNow());
  insert.bind(2, action);
  insert.bind(3, detailJson);
  insert.bind(4, programVersion());
  insert.bind(5, computerName());
  insert.exec();
}

std::string randomKey() {
  std::random_device device;
  std::string key;
  for (int word = 0; word < 4; ++word) {
    key += fmt::format("{:08x}", device());
  }
  return key;
}

}  // namespace ocelli
