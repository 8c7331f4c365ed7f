// The tables of an export (study_export.h) in memory, for programs that go on with them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "study/export/export_columns.h"
#include "study/export/study_export.h"

namespace ocelli {

/// As the database holds it; nothing where there is no value.
using StudyValue = std::variant<std::monostate, int64_t, double, std::string>;

struct StudyTable {
  std::string name;                             ///< "trials", as the file of an export is called
  std::vector<ColumnMeaning> columns;           ///< in the order of the export
  std::vector<std::vector<StudyValue>> values;  ///< of each column, from the first row on
};

/// What exportStudy() writes in the form CSV, all of the same moment. The database is only read: it does not know who
/// has its data, and a withdrawal does not find them. `options` say which tables there are, and nothing of files.
/// Throws InputError where the database is missing, damaged or no study's.
std::vector<StudyTable> studyTables(const std::filesystem::path& database, const ExportOptions& options,
                                    const Progress& progress = {});

}  // namespace ocelli
