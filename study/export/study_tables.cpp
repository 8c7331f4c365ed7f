#include "study/export/study_tables.h"

#include <SQLiteCpp/Transaction.h>

#include "study/export/export_tables.h"
#include "study/store/sqlite_connection.h"

namespace ocelli {
namespace {

StudyValue valueOf(const SQLite::Column& value) {
  if (value.isInteger()) {
    return value.getInt64();
  }
  if (value.isFloat()) {
    return value.getDouble();
  }
  return value.isNull() ? StudyValue() : StudyValue(value.getString());
}

StudyTable readTable(SQLite::Database& database, const ExportTable& table) {
  StudyTable read{table.name, meaningsOf(database, table), {}};
  read.values.resize(read.columns.size());
  SQLite::Statement row(database, table.query);
  while (row.executeStep()) {
    for (size_t column = 0; column < read.columns.size(); ++column) {
      read.values[column].push_back(valueOf(row.getColumn(static_cast<int>(column))));
    }
  }
  return read;
}

}  // namespace

std::vector<StudyTable> studyTables(const std::filesystem::path& path, const ExportOptions& options,
                                    const Progress& progress) {
  SQLite::Database database = connectStudy(path, DatabaseAccess::kRead);
  return withSqliteErrors("read this database", path, [&] {
    const SQLite::Transaction snapshot(database);
    std::vector<ExportTable> planned = tablesBesideTrials(studyFactsOf(database, path).protocol, options);
    planned.insert(planned.begin(), trialsTable(database, ""));
    std::vector<StudyTable> tables;
    for (const ExportTable& table : planned) {
      report(progress, "reading the study", static_cast<double>(tables.size()) / static_cast<double>(planned.size()));
      tables.push_back(readTable(database, table));
    }
    return tables;
  });
}

}  // namespace ocelli
