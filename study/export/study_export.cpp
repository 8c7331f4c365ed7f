#include "study/export/study_export.h"

#include <SQLiteCpp/Transaction.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>

#include "oc_core/base/csv.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "study/export/export_tables.h"
#include "study/export/psych_ds.h"
#include "study/session/utc_time.h"
#include "study/store/database_lock.h"
#include "study/store/export_record.h"
#include "study/store/program_version.h"
#include "study/store/sqlite_connection.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

/// A table and the file that it goes to, in the folder.
struct PlannedFile {
  ExportTable table;
  std::string file;
};

std::vector<PlannedFile> planFiles(SQLite::Database& database, const StudyFacts& study, const ExportOptions& options) {
  std::vector<PlannedFile> files;
  const bool isPsychDs = options.form == ExportForm::kPsychDs;
  if (isPsychDs) {
    for (const std::string& task : tasksOf(database)) {
      files.push_back({trialsTable(database, task), "data/" + psychDsFileName(study.name, "task", task)});
    }
  } else {
    files.push_back({trialsTable(database, ""), "trials.csv"});
  }
  for (ExportTable& table : tablesBesideTrials(study.protocol, options)) {
    std::string file =
        isPsychDs ? "data/" + psychDsFileName(study.name, "description", table.name) : table.name + ".csv";
    files.push_back({std::move(table), std::move(file)});
  }
  return files;
}

/// Files that stand beside the tables.
std::vector<std::string> otherFiles(ExportForm form) {
  if (form == ExportForm::kCsv) {
    return {"columns.csv"};
  }
  return {"dataset_description.json", "README.md", "CHANGES.md", "materials/protocol.json"};
}

/// Files in that folder that the database knows to be of earlier exports.
std::vector<fs::path> earlierFiles(SQLite::Database& database, const fs::path& folder) {
  std::vector<fs::path> files;
  for (const ExportRecord& record : exportRecordsOf(database)) {
    if (!record.isReport && record.folder == folder) {
      for (const std::string& file : record.files) {
        files.push_back(folder / file);
      }
    }
  }
  return files;
}

void prepareFolder(SQLite::Database& database, const fs::path& folder, const ExportOptions& options) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    throw InputError("this is a file, not a folder", folder.string(), "the name of a folder");
  }
  if (fs::exists(folder, error) && !fs::is_empty(folder, error)) {
    if (!options.overwrite) {
      throw InputError("this folder holds files already", folder.string(),
                       "another folder; or --force, which replaces an earlier export and leaves other files alone");
    }
    for (const fs::path& file : earlierFiles(database, folder)) {
      fs::remove(file, error);
    }
  }
  fs::create_directories(options.form == ExportForm::kPsychDs ? folder / "data" : folder, error);
  if (!error && options.form == ExportForm::kPsychDs) {
    fs::create_directories(folder / "materials", error);
  }
  if (error) {
    throw WorkError(fmt::format("cannot make this folder ({})", error.message()), folder.string(),
                    "check that the folder above it exists and may be written to");
  }
}

/// Whether its rights and its disk let the database be written, as its audit trail must be.
bool canBeWritten(const fs::path& path) {
  const fs::path file = withoutLinks(path);
  return faccessat(AT_FDCWD, file.c_str(), W_OK, AT_EACCESS) == 0 &&
         faccessat(AT_FDCWD, file.parent_path().c_str(), W_OK, AT_EACCESS) == 0;
}

/// The audit trail is text. A name that it cannot hold would keep a withdrawal from finding the files.
void checkName(const fs::path& folder) {
  try {
    std::ignore = nlohmann::json(folder.string()).dump();
  } catch (const nlohmann::json::exception&) {
    throw InputError("the name of this folder is no UTF-8, so the database cannot keep where its exports are",
                     folder.string(), "a folder with another name");
  }
}

/// Each column once, in the order in which they come.
std::vector<ColumnMeaning> allColumns(SQLite::Database& database, const std::vector<PlannedFile>& files) {
  std::vector<ColumnMeaning> all;
  for (const PlannedFile& file : files) {
    for (const ColumnMeaning& column : meaningsOf(database, file.table)) {
      if (std::none_of(all.begin(), all.end(), [&](const ColumnMeaning& m) { return m.name == column.name; })) {
        all.push_back(column);
      }
    }
  }
  return all;
}

void writeColumns(SQLite::Database& database, const std::vector<PlannedFile>& files, const fs::path& path) {
  std::string text = "file,column,unit,meaning\r\n";
  for (const PlannedFile& file : files) {
    for (const ColumnMeaning& column : meaningsOf(database, file.table)) {
      text += fmt::format("{},{},{},{}\r\n", csvText(file.file), csvText(column.name), csvText(column.unit),
                          csvText(column.description));
    }
  }
  writeFile(path, text);
}

void writePsychDsTexts(SQLite::Database& database, const StudyFacts& study, const std::vector<PlannedFile>& files,
                       const ExportReport& report, const fs::path& folder) {
  PsychDsText text;
  text.studyTitle = study.name;
  text.protocolSha256 = study.sha256;
  text.programVersion = programVersion();
  text.dateUtc = utcNow();
  text.subjects = report.subjects;
  text.simulatedSubjects = report.simulatedSubjects;
  for (const PlannedFile& file : files) {
    text.dataFiles.push_back(file.file);
  }
  text.columns = allColumns(database, files);
  writeFile(folder / "dataset_description.json", datasetDescription(text));
  writeFile(folder / "README.md", psychDsReadme(text));
  writeFile(folder / "CHANGES.md", psychDsChanges(text));
  writeFile(folder / "materials" / "protocol.json", study.protocol);
}

}  // namespace

ExportReport exportStudy(const fs::path& path, const fs::path& target, const ExportOptions& options,
                         const Progress& progress) {
  const fs::path folder = fs::absolute(target).lexically_normal();
  checkName(folder);
  ExportReport report;
  std::error_code ignored;
  report.recorded = !fs::exists(path, ignored) || canBeWritten(path);
  // What cannot be written cannot be withdrawn from meanwhile.
  std::optional<DatabaseLock> lock;
  if (report.recorded && fs::exists(path, ignored)) {
    lock.emplace(path, DatabaseUse::kExport);
  }
  SQLite::Database database = connectStudy(path, report.recorded ? DatabaseAccess::kWrite : DatabaseAccess::kRead);
  return withSqliteErrors("export this database", path, [&] {
    const StudyFacts study = studyFactsOf(database, path);
    prepareFolder(database, folder, options);
    report.files = otherFiles(options.form);
    // All tables are of the same moment, though a session may go on meanwhile. What is planned with, and what is
    // recorded, is of a moment before.
    std::vector<PlannedFile> files = planFiles(database, study, options);
    for (const PlannedFile& file : files) {
      report.files.push_back(file.file);
    }
    if (report.recorded) {
      addExportRecord(database, {folder, report.files});
    }
    SQLite::Transaction snapshot(database);
    report.subjects = database.execAndGet("SELECT count(*) FROM subject").getInt();
    report.simulatedSubjects = database.execAndGet("SELECT count(*) FROM subject WHERE simulated = 1").getInt();
    for (size_t i = 0; i < files.size(); ++i) {
      ocelli::report(progress, "exporting", static_cast<double>(i) / static_cast<double>(files.size()));
      report.rows += writeCsv(database, files[i].table, folder / files[i].file);
    }
    if (options.form == ExportForm::kPsychDs) {
      writePsychDsTexts(database, study, files, report, folder);
    } else {
      writeColumns(database, files, folder / "columns.csv");
    }
    return report;
  });
}

}  // namespace ocelli
