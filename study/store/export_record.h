// What the audit trail of a database keeps of files with rows of its subjects: exports, and reports of analyses. A
// withdrawal finds them by it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace ocelli {

struct ExportRecord {
  std::filesystem::path folder;
  std::vector<std::string> files;  ///< in the folder
  bool isReport = false;           ///< goes as a whole: numbers of it are of its subjects too
};

/// Before the files are written: a withdrawal must know of them even where the program is killed meanwhile. The name of
/// the folder is UTF-8.
void addExportRecord(SQLite::Database& database, const ExportRecord& record);

/// Those that the audit trail has.
std::vector<ExportRecord> exportRecordsOf(SQLite::Database& database);

/// Notes a report of an analysis of that database. False where it cannot be noted: the file is not a database of a
/// study, cannot be written, is being exported or withdrawn from, or the folder's name is no UTF-8. A withdrawal then
/// will not find the report.
bool recordReport(const std::filesystem::path& database, const std::filesystem::path& folder,
                  const std::vector<std::string>& files);

}  // namespace ocelli
