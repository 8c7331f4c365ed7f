// What a StudyDatabase holds. For .cpp files: it shows SQLiteCpp.
#pragma once

#include <optional>

#include "study/store/database_lock.h"
#include "study/store/sqlite_connection.h"
#include "study/store/study_database.h"
#include "study/store/trials_schema.h"

namespace ocelli {

struct StudyDatabase::State {
  State(std::filesystem::path file, DatabaseAccess access, std::optional<DatabaseLock> held)
      : path(std::move(file)), lock(std::move(held)), database(connectStudy(path, access)) {}

  std::filesystem::path path;
  std::optional<DatabaseLock> lock;  ///< outlives the connection
  SQLite::Database database;
};

}  // namespace ocelli
