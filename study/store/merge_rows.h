// The rows that one database has and another lacks.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "study/store/merge.h"

namespace SQLite {
class Database;
}

namespace ocelli {

/// Adds what `database` lacks of `source`, all of it or nothing, with a line in the audit trail; nothing of subjects
/// with the ids `left`. A run that both have is one that the database got from a copy made while it ran: what has come
/// since is added. That both fit together must have been checked.
MergeReport addMissingRows(SQLite::Database& database, const std::filesystem::path& source,
                           const std::set<std::string>& left);

}  // namespace ocelli
