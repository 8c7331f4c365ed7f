// Databases of older versions of this program, brought up to date.
//
// Recipe for a change of the tables:
//   1. protocols/trials.schema.sql: the new tables, and `user_version` one higher.
//   2. study/store/trials_schema.h: the same number.
//   3. study/store/migrations.cpp: one entry in the table, SQL that makes the old tables the new ones and keeps all
//      rows, triggers included. It stays as it is when the tables change again. tests/study_store/migrations_test.cpp
//      checks that the numbers agree, and that a file of each version becomes what new files are.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace ocelli {

struct Migration {
  int from = 0;     ///< `user_version` that it takes to the next
  std::string sql;  ///< without transactions; `user_version` is set by migrate()
};

const std::vector<Migration>& migrations();

/// Takes the database to `version`, all in one transaction, with a line in the audit trail. Throws InputError where a
/// step is missing; the database then stays as it was.
void migrate(SQLite::Database& database, const std::vector<Migration>& steps, int version,
             const std::filesystem::path& path);

}  // namespace ocelli
