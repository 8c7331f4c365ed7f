// What deleted rows leave in the files of a database.
#pragma once

#include <filesystem>

namespace SQLite {
class Database;
}

namespace ocelli {

/// Where a withdrawal has deleted rows but was stopped before their bytes were gone: does the rest. Throws WorkError
/// where another program still reads the database; what is left is then wiped another time. Call it with the lock held.
void wipeLeftovers(SQLite::Database& database, const std::filesystem::path& path);

}  // namespace ocelli
