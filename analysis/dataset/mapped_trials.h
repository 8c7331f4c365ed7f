// Tables of other tools as the data of an analysis, by a map of columns (column_map.h).
//
// They hold less than a database: no protocol, no consent, no frames, no endings of sessions.
// Dataset::tableFacts says so (mapped_notes.h). The number of a row is the line of its file that it begins on.
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset/column_map.h"
#include "analysis/dataset/dataset.h"

namespace ocelli {

/// One data set of all tables: conditions, cases and duplicates are looked for across them. Throws InputError that says
/// file, line and column for a table that does not fit the map, and for rows that contradict each other: two with one
/// number in a session, a condition that one subject alone has, a subject who is both simulated and not.
Dataset readMappedTables(const std::vector<std::string>& paths, const ColumnMap& map);

}  // namespace ocelli
