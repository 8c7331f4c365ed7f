#include "study/store/leftovers.h"

#include "oc_core/base/error.h"
#include "study/store/sqlite_connection.h"

namespace ocelli {
namespace {

constexpr int kPatienceMilliseconds = 2000;

/// Writes the log back into the database and empties it.
void emptyLog(SQLite::Database& database, const std::filesystem::path& path) {
  database.setBusyTimeout(kPatienceMilliseconds);
  SQLite::Statement checkpoint(database, "PRAGMA wal_checkpoint(TRUNCATE)");
  checkpoint.executeStep();
  if (checkpoint.getColumn(0).getInt() != 0) {
    throw WorkError("rows are deleted, but another program reads this database, so their bytes cannot be wiped yet",
                    path.string(), "close that program, and give the same command again");
  }
}

}  // namespace

void wipeLeftovers(SQLite::Database& database, const std::filesystem::path& path) {
  withSqliteErrors("wipe what was deleted from this database", path, [&] {
    if (database.execAndGet("SELECT leftovers_pending FROM withdrawal").getInt() == 0) {
      return;
    }
    // Written anew, the file has no free pages and no gaps; what the log held before is overwritten and cut off.
    database.exec("VACUUM");
    emptyLog(database, path);
    database.exec("UPDATE withdrawal SET leftovers_pending = 0");
    emptyLog(database, path);
  });
}

}  // namespace ocelli
