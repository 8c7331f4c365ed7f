#include "study/store/withdraw.h"

#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <map>
#include <set>

#include "oc_core/base/error.h"
#include "study/store/database_lock.h"
#include "study/store/export_record.h"
#include "study/store/identity_key.h"
#include "study/store/leftovers.h"
#include "study/store/sqlite_connection.h"
#include "study/store/withdrawals.h"
#include "study/store/word_search.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

/// An export, or a report, that holds the subject, with the files to delete.
struct Holding {
  fs::path name;  ///< of the file, or of the folder of a report
  std::vector<fs::path> files;
  bool isReport = false;
};

/// Those of a record that are still there.
std::vector<fs::path> existingFiles(const ExportRecord& record) {
  std::vector<fs::path> files;
  for (const std::string& name : record.files) {
    // An export that was killed leaves a file half-written (output_file.h).
    for (const char* end : {"", ".partial"}) {
      if (std::error_code ignored; fs::is_regular_file(record.folder / (name + end), ignored)) {
        files.push_back(record.folder / (name + end));
      }
    }
  }
  return files;
}

std::vector<Holding> holdingsOf(SQLite::Database& database, const std::string& subject) {
  std::map<fs::path, Holding> holdings;
  for (const ExportRecord& record : exportRecordsOf(database)) {
    const std::vector<fs::path> files = existingFiles(record);
    for (const fs::path& file : files) {
      if (!fileHoldsWord(file, subject)) {
        continue;
      }
      if (record.isReport) {
        holdings[record.folder] = {record.folder, files, true};
        break;
      }
      holdings[file] = {file, {file}};
    }
  }
  std::vector<Holding> list;
  for (const auto& [name, holding] : holdings) {
    list.push_back(holding);
  }
  return list;
}

std::vector<fs::path> filesWith(SQLite::Database& database, const std::string& subject) {
  std::set<fs::path> files;
  for (const Holding& holding : holdingsOf(database, subject)) {
    files.insert(holding.files.begin(), holding.files.end());
  }
  return {files.begin(), files.end()};
}

/// The folders of a report are its own.
void removeEmptyFolders(const Holding& report) {
  std::error_code ignored;
  for (const fs::path& file : report.files) {
    fs::remove(file.parent_path(), ignored);
  }
  fs::remove(report.name, ignored);
}

int countOf(SQLite::Database& database, const std::string& query, const std::string& subject) {
  SQLite::Statement statement(database, query);
  statement.bind(1, subject);
  statement.executeStep();
  return statement.getColumn(0).getInt();
}

void execute(SQLite::Database& database, const std::string& statement, const std::string& subject) {
  SQLite::Statement prepared(database, statement);
  prepared.bind(1, subject);
  prepared.exec();
}

// Names of exports and of merged databases may hold the id.
void removeFromAudit(SQLite::Database& database, const std::string& subject) {
  SQLite::Statement row(database, "SELECT audit_id, detail_json FROM audit");
  SQLite::Statement update(database, "UPDATE audit SET detail_json = '{\"removed\": true}' WHERE audit_id = ?");
  while (row.executeStep()) {
    if (holdsWord(textOf(row, 1), subject)) {
      update.bind(1, row.getColumn(0).getInt64());
      update.exec();
      update.reset();
    }
  }
}

int notesThatName(SQLite::Database& database, const std::string& subject) {
  int count = 0;
  SQLite::Statement row(database, "SELECT detail FROM event");
  while (row.executeStep()) {
    count += holdsWord(textOf(row, 0), subject) ? 1 : 0;
  }
  return count;
}

void deleteRows(SQLite::Database& database, const std::string& subject) {
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  SQLite::Statement key(database, "SELECT subject_key FROM subject WHERE subject_id = ?");
  key.bind(1, subject);
  key.executeStep();
  const std::string detail = withdrawalDetail(textOf(key, 0));
  key.reset();
  execute(database, "UPDATE withdrawal SET subject_id = ?, leftovers_pending = 1", subject);
  for (const char* table : {"frame", "input", "gaze"}) {
    execute(database,
            fmt::format("DELETE FROM {} WHERE trial_id IN (SELECT trial_id FROM trial WHERE subject_id = ?)", table),
            subject);
  }
  for (const char* table : {"trial", "event", "answer", "consent", "run", "session", "subject"}) {
    execute(database, fmt::format("DELETE FROM {} WHERE subject_id = ?", table), subject);
  }
  removeFromAudit(database, subject);
  database.exec("UPDATE withdrawal SET subject_id = NULL");
  addAudit(database, "withdrawn", detail);
  transaction.commit();
}

std::string joined(const std::vector<Holding>& holdings) {
  std::string text;
  for (const Holding& holding : holdings) {
    text.append(text.empty() ? "" : ", ").append(holding.name.string()).append(holding.isReport ? " (a report)" : "");
  }
  return text;
}

}  // namespace

WithdrawReport withdrawSubject(const fs::path& path, const std::string& subject, const WithdrawOptions& options) {
  const DatabaseLock lock(path);
  const DatabaseLock exports(path, DatabaseUse::kExport);
  SQLite::Database database = connectStudy(path, DatabaseAccess::kWrite);
  return withSqliteErrors("withdraw a subject", path, [&] {
    WithdrawReport report;
    const bool pending = database.execAndGet("SELECT leftovers_pending FROM withdrawal").getInt() != 0;
    wipeLeftovers(database, path);
    report.onlyLeftovers = countOf(database, "SELECT count(*) FROM subject WHERE subject_id = ?", subject) == 0;
    if (report.onlyLeftovers && !pending) {
      throw InputError("this database has no such subject", subject, "`ocelli study subjects` lists them");
    }
    // Everything that can fail comes before the first deletion.
    const std::vector<Holding> holdings = holdingsOf(database, subject);
    const std::vector<fs::path> files = filesWith(database, subject);
    if (!holdings.empty() && !options.deleteExports) {
      throw InputError("exports and reports hold this subject's data: " + joined(holdings), subject,
                       "--delete-exports deletes them; `ocelli study export` and `ocelli analyse` make them anew "
                       "afterwards");
    }
    if (options.keyFile) {
      report.identityRemoved = removeIdentity(*options.keyFile, subject);
    }
    for (const fs::path& file : files) {
      if (std::error_code error; !fs::remove(file, error) && error) {
        throw WorkError(fmt::format("cannot delete this file of an export ({})", error.message()), file.string(),
                        "delete it by hand, and give the same command again");
      }
      report.deletedFiles.push_back(file);
    }
    for (const Holding& holding : holdings) {
      if (holding.isReport) {
        removeEmptyFolders(holding);
      }
    }
    if (report.onlyLeftovers) {
      return report;
    }
    report.sessions = countOf(database, "SELECT count(*) FROM session WHERE subject_id = ?", subject);
    report.trials = countOf(database, "SELECT count(*) FROM trial WHERE subject_id = ?", subject);
    deleteRows(database, subject);
    wipeLeftovers(database, path);
    report.notesThatNameIt = notesThatName(database, subject);
    return report;
  });
}

std::vector<fs::path> exportsWith(const fs::path& path, const std::string& subject) {
  SQLite::Database database = connectStudy(path, DatabaseAccess::kRead);
  return whileReading(path, [&] { return filesWith(database, subject); });
}

}  // namespace ocelli
