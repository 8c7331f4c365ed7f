#include "study/store/merge.h"

#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "oc_core/base/error.h"
#include "study/store/database_lock.h"
#include "study/store/leftovers.h"
#include "study/store/sqlite_connection.h"
#include "study/store/trials_schema.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

/// What must agree between databases that have the same subject: its key, and which run came when in which session.
struct Histories {
  std::map<std::string, std::string> keyOfSubject;
  std::map<std::string, std::string> startOfSession;  ///< by subject and session number
  std::map<std::string, std::string> keyOfRun;        ///< by subject, session number and run number
};

void addOrConflict(std::map<std::string, std::string>& known, const std::string& name, const std::string& value,
                   const std::string& subject, std::set<std::string>& conflicts) {
  const auto [place, isNew] = known.emplace(name, value);
  if (!isNew && place->second != value) {
    conflicts.insert(subject);
  }
}

/// Adds those of a database; subjects that contradict earlier ones go to `conflicts`.
void addHistories(SQLite::Database& database, Histories& known, std::set<std::string>& conflicts) {
  SQLite::Statement subject(database, "SELECT subject_id, subject_key FROM subject");
  while (subject.executeStep()) {
    addOrConflict(known.keyOfSubject, textOf(subject, 0), textOf(subject, 1), textOf(subject, 0), conflicts);
  }
  SQLite::Statement session(database,
                            "SELECT subject_id, subject_id || ' ' || session_number, started_utc || ' ' || seed "
                            "FROM session");
  while (session.executeStep()) {
    addOrConflict(known.startOfSession, textOf(session, 1), textOf(session, 2), textOf(session, 0), conflicts);
  }
  SQLite::Statement run(
      database, "SELECT subject_id, subject_id || ' ' || session_number || ' ' || run_number, run_key FROM run");
  while (run.executeStep()) {
    addOrConflict(known.keyOfRun, textOf(run, 1), textOf(run, 2), textOf(run, 0), conflicts);
  }
}

struct StudyRow {
  std::string name;
  std::string sha256;
  std::string text;
};

std::optional<StudyRow> studyOf(SQLite::Database& database) {
  SQLite::Statement row(database, "SELECT protocol_name, protocol_sha256, protocol_text FROM study");
  if (!row.executeStep()) {
    return std::nullopt;
  }
  return StudyRow{textOf(row, 0), textOf(row, 1), textOf(row, 2)};
}

/// Opens it to be read, and not brought up to date: sources stay as they are.
SQLite::Database openSource(const fs::path& source) {
  SQLite::Database database = connectSqlite(source, DatabaseAccess::kRead);
  withSqliteErrors("read this database", source, [&] {
    if (database.execAndGet("PRAGMA application_id").getInt() == kTrialsApplicationId &&
        database.execAndGet("PRAGMA user_version").getInt() < kTrialsSchemaVersion) {
      throw InputError("this database is of an older version", source.string(),
                       "`ocelli study subjects --db FILE` brings it up to date");
    }
  });
  return connectStudy(source, DatabaseAccess::kRead);
}

/// Names of the table's columns but `left`, separated by commas, each with `prefix`.
std::string columnsOf(SQLite::Database& database, const std::string& table, const std::set<std::string>& left,
                      const std::string& prefix) {
  SQLite::Statement row(database, "SELECT name FROM pragma_table_info(?)");
  row.bind(1, table);
  std::string columns;
  while (row.executeStep()) {
    if (!left.contains(textOf(row, 0))) {
      columns += std::string(columns.empty() ? "" : ", ").append(prefix).append(textOf(row, 0));
    }
  }
  return columns;
}

/// Copies the rows of a table that belong to rows that are new, which `join` says. `renumbered` maps a column to what
/// stands in for it; an empty text leaves it to SQLite.
void copyRows(SQLite::Database& database, const std::string& table,
              const std::map<std::string, std::string>& renumbered, const std::string& join) {
  std::set<std::string> left;
  std::string into;
  std::string from;
  for (const auto& [column, expression] : renumbered) {
    left.insert(column);
    if (!expression.empty()) {
      into += column + ", ";
      from += expression + ", ";
    }
  }
  database.exec(fmt::format("INSERT INTO main.{0} ({1}{2}) SELECT {3}{4} FROM source.{0} AS s {5}", table, into,
                            columnsOf(database, table, left, ""), from, columnsOf(database, table, left, "s."), join));
}

/// Adds what the target lacks of one source, in one transaction.
MergeReport mergeOne(SQLite::Database& database, const fs::path& source) {
  SQLite::Statement attach(database, "ATTACH ? AS source");
  attach.bind(1, uriForReading(source));
  attach.exec();
  const auto count = [&](const std::string& query) { return database.execAndGet(query).getInt(); };
  MergeReport report;
  {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    report.knownSubjects =
        count("SELECT count(*) FROM source.subject WHERE subject_key IN (SELECT subject_key FROM main.subject)");
    report.subjects = count("SELECT count(*) FROM source.subject") - report.knownSubjects;
    database.exec(
        "CREATE TEMP TABLE new_run AS SELECT run_id AS old_id, row_number() OVER (ORDER BY run_id) + "
        "(SELECT coalesce(max(run_id), 0) FROM main.run) AS new_id FROM source.run "
        "WHERE run_key NOT IN (SELECT run_key FROM main.run);"
        "CREATE TEMP TABLE new_trial AS SELECT trial_id AS old_id, row_number() OVER (ORDER BY trial_id) + "
        "(SELECT coalesce(max(trial_id), 0) FROM main.trial) AS new_id FROM source.trial "
        "WHERE run_id IN (SELECT old_id FROM new_run);"
        "CREATE INDEX temp.new_trial_old ON new_trial (old_id)");
    report.runs = count("SELECT count(*) FROM new_run");
    report.trials = count("SELECT count(*) FROM new_trial");
    const std::string ofRun = "JOIN new_run ON new_run.old_id = s.run_id";
    const std::string ofTrial = "JOIN new_trial ON new_trial.old_id = s.trial_id";
    copyRows(database, "subject", {}, "WHERE s.subject_key NOT IN (SELECT subject_key FROM main.subject)");
    copyRows(database, "session", {},
             "WHERE (s.subject_id, s.session_number) NOT IN (SELECT subject_id, session_number FROM main.session)");
    copyRows(database, "run", {{"run_id", "new_run.new_id"}}, ofRun);
    copyRows(database, "consent", {{"consent_id", ""}, {"run_id", "new_run.new_id"}}, ofRun + " ORDER BY s.consent_id");
    copyRows(database, "answer", {{"answer_id", ""}, {"run_id", "new_run.new_id"}}, ofRun + " ORDER BY s.answer_id");
    copyRows(database, "event", {{"event_id", ""}, {"run_id", "new_run.new_id"}}, ofRun + " ORDER BY s.event_id");
    copyRows(database, "trial", {{"trial_id", "new_trial.new_id"}, {"run_id", "new_run.new_id"}},
             ofRun + " " + ofTrial);
    copyRows(database, "frame", {{"trial_id", "new_trial.new_id"}}, ofTrial);
    copyRows(database, "input", {{"trial_id", "new_trial.new_id"}}, ofTrial);
    database.exec("DROP TABLE new_trial; DROP TABLE new_run");
    if (report.subjects > 0 || report.runs > 0) {
      const nlohmann::ordered_json detail = {{"source", fs::absolute(source).string()},
                                             {"subjects", report.subjects},
                                             {"runs", report.runs},
                                             {"trials", report.trials}};
      addAudit(database, "merged", detail.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    }
    transaction.commit();
  }
  database.exec("DETACH source");
  return report;
}

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text.append(text.empty() ? "" : ", ").append(name);
  }
  return text;
}

/// Makes sure that everything fits together; returns the study.
StudyRow checkSources(const fs::path& target, const std::vector<fs::path>& sources) {
  Histories histories;
  std::set<std::string> conflicts;
  std::optional<StudyRow> study;
  fs::path first;
  std::vector<fs::path> all = sources;
  if (std::error_code ignored; fs::exists(target, ignored) && fs::file_size(target, ignored) > 0) {
    all.insert(all.begin(), target);
  }
  for (const fs::path& path : all) {
    if (const std::optional<std::string> holder = DatabaseLock::holderOf(path); holder && path != target) {
      throw WorkError("a program runs sessions on this database: " + *holder, path.string(), "close that program");
    }
    SQLite::Database database = openSource(path);
    withSqliteErrors("read this database", path, [&] {
      const std::optional<StudyRow> here = studyOf(database);
      if (!here) {
        throw InputError("this database holds no study yet", path.string(), "leave it out");
      }
      if (!study) {
        study = here;
        first = path;
      } else if (study->sha256 != here->sha256) {
        throw InputError(fmt::format("this database is of another protocol (\"{}\", SHA-256 {}...) than {} (\"{}\", "
                                     "{}...)",
                                     here->name, here->sha256.substr(0, 12), first.string(), study->name,
                                     study->sha256.substr(0, 12)),
                         path.string(), "only databases of the same protocol can be merged");
      }
      addHistories(database, histories, conflicts);
    });
  }
  if (!conflicts.empty()) {
    throw InputError("these databases use the same ids for different subjects: " + joined(conflicts), target.string(),
                     "stations must give different ids; merge without the database whose ids are wrong");
  }
  return *study;
}

void addStudy(SQLite::Database& database, const StudyRow& study) {
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  if (!studyOf(database)) {
    insertStudy(database, study.name, study.sha256, study.text);
  }
  transaction.commit();
}

}  // namespace

MergeReport mergeDatabases(const fs::path& target, const std::vector<fs::path>& sources) {
  for (const fs::path& source : sources) {
    if (std::error_code ignored; fs::equivalent(source, target, ignored)) {
      throw InputError("a database cannot be merged into itself", source.string(), "another --db");
    }
  }
  const DatabaseLock lock(target);
  const StudyRow study = checkSources(target, sources);
  SQLite::Database database = connectStudy(target, DatabaseAccess::kCreate);
  return withSqliteErrors("merge databases", target, [&] {
    wipeLeftovers(database, target);
    addStudy(database, study);
    MergeReport total;
    for (const fs::path& source : sources) {
      const MergeReport report = mergeOne(database, source);
      total.subjects += report.subjects;
      total.runs += report.runs;
      total.trials += report.trials;
      total.knownSubjects += report.knownSubjects;
    }
    return total;
  });
}

std::vector<int> slotUse(const fs::path& path, bool simulated) {
  SQLite::Database database = connectStudy(path, DatabaseAccess::kRead);
  return withSqliteErrors("read this database", path, [&] {
    std::vector<int> use;
    SQLite::Statement row(database,
                          "SELECT slot, count(*) FROM subject WHERE simulated = ? GROUP BY slot ORDER BY slot");
    row.bind(1, simulated ? 1 : 0);
    while (row.executeStep()) {
      use.resize(static_cast<size_t>(row.getColumn(0).getInt()) + 1, 0);
      use.back() = row.getColumn(1).getInt();
    }
    return use;
  });
}

}  // namespace ocelli
