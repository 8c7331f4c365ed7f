#include "study/store/merge.h"

#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "oc_core/base/error.h"
#include "study/store/database_lock.h"
#include "study/store/leftovers.h"
#include "study/store/merge_rows.h"
#include "study/store/sqlite_connection.h"
#include "study/store/trials_schema.h"
#include "study/store/withdrawals.h"

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

/// Adds those of a database but for the subjects `left`; subjects that contradict earlier ones go to `conflicts`.
void addHistories(SQLite::Database& database, const std::set<std::string>& left, Histories& known,
                  std::set<std::string>& conflicts) {
  const auto add = [&](std::map<std::string, std::string>& of, const std::string& name, const std::string& value,
                       const std::string& subject) {
    if (!left.contains(subject)) {
      addOrConflict(of, name, value, subject, conflicts);
    }
  };
  SQLite::Statement subject(database, "SELECT subject_id, subject_key FROM subject");
  while (subject.executeStep()) {
    add(known.keyOfSubject, textOf(subject, 0), textOf(subject, 1), textOf(subject, 0));
  }
  SQLite::Statement session(database,
                            "SELECT subject_id, subject_id || ' ' || session_number, started_utc || ' ' || seed "
                            "FROM session");
  while (session.executeStep()) {
    add(known.startOfSession, textOf(session, 1), textOf(session, 2), textOf(session, 0));
  }
  SQLite::Statement run(
      database, "SELECT subject_id, subject_id || ' ' || session_number || ' ' || run_number, run_key FROM run");
  while (run.executeStep()) {
    add(known.keyOfRun, textOf(run, 1), textOf(run, 2), textOf(run, 0));
  }
}

/// Subjects that withdrew elsewhere.
std::set<std::string> withdrawnSubjects(SQLite::Database& database, const std::vector<Withdrawal>& withdrawals) {
  std::set<std::string> subjects;
  SQLite::Statement subject(database, "SELECT subject_id, subject_key FROM subject");
  while (!withdrawals.empty() && subject.executeStep()) {
    if (isWithdrawn(withdrawals, textOf(subject, 1))) {
      subjects.insert(textOf(subject, 0));
    }
  }
  return subjects;
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
  whileReading(source, [&] {
    if (database.execAndGet("PRAGMA application_id").getInt() == kTrialsApplicationId &&
        database.execAndGet("PRAGMA user_version").getInt() < kTrialsSchemaVersion) {
      throw InputError("this database is of an older version", source.string(),
                       "`ocelli study subjects --db FILE` brings it up to date");
    }
  });
  return connectStudy(source, DatabaseAccess::kRead);
}

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text.append(text.empty() ? "" : ", ").append(name);
  }
  return text;
}

struct Checked {
  StudyRow study;
  std::vector<Withdrawal> withdrawals;                  ///< from the target or a source
  std::map<fs::path, std::set<std::string>> withdrawn;  ///< subjects of each database who withdrew from one of them
};

/// Opens a database to be merged, which no session may write meanwhile.
SQLite::Database openIdle(const fs::path& path, const fs::path& target) {
  if (const std::optional<std::string> holder = DatabaseLock::holderOf(path); holder && path != target) {
    throw WorkError("a program runs sessions on this database: " + *holder, path.string(), "close that program");
  }
  return openSource(path);
}

/// Makes sure that everything fits together.
Checked checkSources(const fs::path& target, const std::vector<fs::path>& sources) {
  Histories histories;
  std::set<std::string> conflicts;
  std::optional<StudyRow> study;
  Checked checked;
  std::vector<fs::path> all = sources;
  if (std::error_code ignored; fs::exists(target, ignored) && fs::file_size(target, ignored) > 0) {
    all.insert(all.begin(), target);
  }
  for (const fs::path& path : all) {
    SQLite::Database database = openIdle(path, target);
    whileReading(path, [&] {
      const std::optional<StudyRow> here = studyOf(database);
      if (!here) {
        throw InputError("this database holds no study yet", path.string(), "leave it out");
      }
      if (!study) {
        study = here;
      } else if (study->sha256 != here->sha256) {
        throw InputError(fmt::format("this database is of another protocol (\"{}\", SHA-256 {}...) than {} (\"{}\", "
                                     "{}...)",
                                     here->name, here->sha256.substr(0, 12), all.front().string(), study->name,
                                     study->sha256.substr(0, 12)),
                         path.string(), "only databases of the same protocol can be merged");
      }
      const std::vector<Withdrawal> withdrawals = withdrawalsOf(database);
      checked.withdrawals.insert(checked.withdrawals.end(), withdrawals.begin(), withdrawals.end());
    });
  }
  // Who withdrew from one of them does not come back by way of another.
  for (const fs::path& path : all) {
    SQLite::Database database = openIdle(path, target);
    whileReading(path, [&] {
      checked.withdrawn[path] = withdrawnSubjects(database, checked.withdrawals);
      addHistories(database, path == target ? std::set<std::string>() : checked.withdrawn[path], histories, conflicts);
    });
  }
  if (!conflicts.empty()) {
    throw InputError("these databases use the same ids for different subjects: " + joined(conflicts), target.string(),
                     "stations must give different ids; merge without the database whose ids are wrong");
  }
  checked.study = *study;
  return checked;
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
  const Checked checked = checkSources(target, sources);
  SQLite::Database database = connectStudy(target, DatabaseAccess::kCreate);
  return withSqliteErrors("merge databases", target, [&] {
    wipeLeftovers(database, target);
    addStudy(database, checked.study);
    rememberWithdrawals(database, checked.withdrawals);
    MergeReport total;
    if (const auto here = checked.withdrawn.find(target); here != checked.withdrawn.end()) {
      total.withdrewElsewhere = here->second;
    }
    for (const fs::path& source : sources) {
      const std::set<std::string>& withdrawn = checked.withdrawn.at(source);
      const MergeReport report = addMissingRows(database, source, withdrawn);
      total.subjects += report.subjects;
      total.runs += report.runs;
      total.runsThatWentOn += report.runsThatWentOn;
      total.trials += report.trials;
      total.knownSubjects += report.knownSubjects;
      total.withdrawnSubjects.insert(withdrawn.begin(), withdrawn.end());
    }
    return total;
  });
}

std::vector<int> slotUse(const fs::path& path, bool simulated) {
  SQLite::Database database = connectStudy(path, DatabaseAccess::kRead);
  return whileReading(path, [&] {
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
