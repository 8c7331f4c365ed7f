#include "study/store/migrations.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/error.h"
#include "study/store/sqlite_connection.h"
#include "study/store/trials_schema.h"

namespace ocelli {

const std::vector<Migration>& migrations() {
  static const std::vector<Migration> steps{
      {1, migrationOfVersion1()}, {2, migrationOfVersion2()}, {3, migrationOfVersion3()}};
  return steps;
}

void migrate(SQLite::Database& database, const std::vector<Migration>& steps, int version,
             const std::filesystem::path& path) {
  withSqliteErrors("bring this database up to date", path, [&] {
    // Tables may be made anew; what refers to them is checked at the end.
    database.exec("PRAGMA foreign_keys = OFF");
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    const int first = database.execAndGet("PRAGMA user_version").getInt();
    for (int from = first; from < version; ++from) {
      const auto step = std::find_if(steps.begin(), steps.end(), [&](const Migration& s) { return s.from == from; });
      if (step == steps.end()) {
        throw InputError(fmt::format("this database has version {}, which is no longer known", from), path.string(),
                         "an older version of ocelli");
      }
      database.exec(step->sql);
    }
    if (first < version) {
      if (SQLite::Statement(database, "PRAGMA foreign_key_check").executeStep()) {
        throw WorkError("rows of this database do not fit together", path.string(), "take the last backup");
      }
      database.exec(fmt::format("PRAGMA user_version = {}", version));
      addAudit(database, "migrated", fmt::format(R"({{"from": {}, "to": {}}})", first, version));
    }
    transaction.commit();
    database.exec("PRAGMA foreign_keys = ON");
  });
}

}  // namespace ocelli
