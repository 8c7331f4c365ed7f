// The tables of chapter 7 of Rosen 2010 from any data, beside the published values: subjects (section 7.4.1), searches
// (section 7.4.2, Table 7.1, Figure 7.5), counts (section 7.4.3, Tables 7.2 and 7.3), paths (7.4.4), survey (7.4.5).
//
// Where the text does not say whose trials a number is of, they are those of the first session of all subjects.
#pragma once

#include <vector>

#include "analysis/dataset/exclusions.h"
#include "analysis/tables/table.h"
#include "analysis/tables/table_cells.h"

namespace ocelli {

struct PaperTableOptions {
  TimeoutsInMeans timeouts = TimeoutsInMeans::kRemoved;  ///< as the text does
};

/// What the data do not have is "no trials". Studies by other protocols than those of Rosen 2010 get the same tables
/// under other names and without published values (neutral_tables.h). Names of the tables: "subjects", "section-7.4.2",
/// "time-outs", "table-7.1", "figure-7.5", "section-7.4.3", "table-7.2-left", "table-7.2-right", "table-7.3",
/// "count-errors", "section-7.4.4", "section-7.4.5".
std::vector<Table> paperTables(const AnalysisData& analysis, const PaperTableOptions& options = {});

}  // namespace ocelli
