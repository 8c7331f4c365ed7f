// The tables of an export, each a query whose columns export_columns.h explains. For .cpp files: it shows SQLiteCpp.
#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <string>
#include <vector>

#include "study/export/export_columns.h"
#include "study/export/study_export.h"
#include "study/outline/form_outline.h"

namespace ocelli {

struct ExportTable {
  std::string name;  ///< "trials"
  std::string query;
  std::vector<std::string> measures{};  ///< columns that are a task's own
};

ExportTable subjectsTable();
ExportTable runsTable();
/// Of one task, or of all where `task` is empty.
ExportTable trialsTable(SQLite::Database& database, const std::string& task);
/// `forms` are those of the protocol.
ExportTable answersTable(const std::vector<ProtocolForm>& forms);
ExportTable eventsTable(bool notes);
ExportTable framesTable();
ExportTable inputsTable();
ExportTable gazeTable();

/// What the database says of its study.
struct StudyFacts {
  std::string name;      ///< of the protocol
  std::string sha256;    ///< of the protocol's text
  std::string protocol;  ///< its text
};
/// Throws InputError, naming `path`, where no study stands in it yet.
StudyFacts studyFactsOf(SQLite::Database& database, const std::filesystem::path& path);

/// All tables but those of trials, of a protocol's text; those that `options` ask for.
std::vector<ExportTable> tablesBesideTrials(const std::string& protocol, const ExportOptions& options);

/// Names of the tasks that trials were of.
std::vector<std::string> tasksOf(SQLite::Database& database);

/// What the columns of a table mean, in their order.
std::vector<ColumnMeaning> meaningsOf(SQLite::Database& database, const ExportTable& table);

/// Writes the table as CSV (RFC 4180, UTF-8) and returns the number of its rows.
int64_t writeCsv(SQLite::Database& database, const ExportTable& table, const std::filesystem::path& file);

}  // namespace ocelli
