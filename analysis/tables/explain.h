// Where a number comes from: the rows behind a cell.
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/tables/table.h"

namespace ocelli {

/// Text that says what the cell means, and lists its rows: of trials file, number, subject, session, case, view, time
/// and answer; with the command of SQLite that shows them in their databases. `data` is what the tables were made of.
/// Throws InputError, with names that are close, where there is no such cell.
std::string explainCell(const std::vector<Table>& tables, const Dataset& data, const std::string& name);

/// The command that lists these rows of one source, such as
/// sqlite3 -readonly 'study.db' "SELECT * FROM final_trial WHERE trial_id IN (1, 5)".
/// Empty where the source is no database.
std::string queryOf(const Cell& cell, const DataSource& source, int sourceIndex);

}  // namespace ocelli
