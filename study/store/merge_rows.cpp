#include "study/store/merge_rows.h"

#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "study/store/sqlite_connection.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

/// The table's columns but `left`, each in `form`, separated by commas.
std::string columnsOf(SQLite::Database& database, const std::string& table, const std::set<std::string>& left,
                      const std::string& form) {
  SQLite::Statement row(database, "SELECT name FROM pragma_table_info(?)");
  row.bind(1, table);
  std::string columns;
  while (row.executeStep()) {
    if (!left.contains(textOf(row, 0))) {
      columns += std::string(columns.empty() ? "" : ", ").append(fmt::format(fmt::runtime(form), textOf(row, 0)));
    }
  }
  return columns;
}

/// Copies the rows of a table that `join` leaves. `renumbered` maps a column to what stands in for it; an empty text
/// leaves it to SQLite.
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
                            columnsOf(database, table, left, "{}"), from, columnsOf(database, table, left, "s.{}"),
                            join));
}

/// Tables `left_subject`, `merged_run` and `merged_trial`: which rows of the source become which, whether they are
/// known, and how much of them is. Trials that have ended in the target are complete and not among them.
void mapRows(SQLite::Database& database, const std::set<std::string>& left) {
  database.exec("CREATE TEMP TABLE left_subject (subject_id TEXT PRIMARY KEY)");
  SQLite::Statement insert(database, "INSERT INTO left_subject VALUES (?)");
  for (const std::string& subject : left) {
    insert.bind(1, subject);
    insert.exec();
    insert.reset();
  }
  database.exec(
      "CREATE TEMP TABLE merged_run AS SELECT s.run_id AS old_id, t.run_id IS NOT NULL AS known, "
      "coalesce(t.run_id, (SELECT coalesce(max(run_id), 0) FROM main.run) + "
      "row_number() OVER (PARTITION BY t.run_id IS NULL ORDER BY s.run_id)) AS new_id, "
      "(SELECT count(*) FROM main.consent WHERE run_id = t.run_id) AS consents, "
      "(SELECT count(*) FROM main.answer WHERE run_id = t.run_id) AS answers, "
      "(SELECT count(*) FROM main.event WHERE run_id = t.run_id) AS events "
      "FROM source.run AS s LEFT JOIN main.run AS t USING (run_key) "
      "WHERE s.subject_id NOT IN (SELECT subject_id FROM left_subject);"
      "CREATE UNIQUE INDEX temp.merged_run_old ON merged_run (old_id);"
      "CREATE TEMP TABLE merged_trial AS SELECT s.trial_id AS old_id, t.trial_id IS NOT NULL AS known, "
      "coalesce(t.trial_id, (SELECT coalesce(max(trial_id), 0) FROM main.trial) + "
      "row_number() OVER (PARTITION BY t.trial_id IS NULL ORDER BY s.trial_id)) AS new_id, "
      "(SELECT coalesce(max(frame) + 1, 0) FROM main.frame WHERE trial_id = t.trial_id) AS frames, "
      "(SELECT coalesce(max(input_index) + 1, 0) FROM main.input WHERE trial_id = t.trial_id) AS inputs, "
      "(SELECT coalesce(max(gaze_index) + 1, 0) FROM main.gaze WHERE trial_id = t.trial_id) AS gazes "
      "FROM source.trial AS s JOIN merged_run AS r ON r.old_id = s.run_id "
      "LEFT JOIN main.trial AS t ON t.run_id = r.new_id AND t.trial_number = s.trial_number WHERE t.ending IS NULL;"
      "CREATE UNIQUE INDEX temp.merged_trial_old ON merged_trial (old_id)");
}

MergeReport countMissing(SQLite::Database& database) {
  const auto count = [&](const std::string& query) { return database.execAndGet(query).getInt(); };
  const std::string others = "FROM source.subject WHERE subject_id NOT IN (SELECT subject_id FROM left_subject)";
  MergeReport report;
  report.knownSubjects =
      count("SELECT count(*) " + others + " AND subject_key IN (SELECT subject_key FROM main.subject)");
  report.subjects = count("SELECT count(*) " + others) - report.knownSubjects;
  report.runs = count("SELECT count(*) FROM merged_run WHERE NOT known");
  report.trials = count("SELECT count(*) FROM merged_trial WHERE NOT known");
  report.runsThatWentOn = count(
      "SELECT count(*) FROM merged_run AS r JOIN source.run AS s ON s.run_id = r.old_id "
      "JOIN main.run AS t ON t.run_id = r.new_id WHERE r.known AND ((t.ending IS NULL AND s.ending IS NOT NULL) "
      "OR r.consents < (SELECT count(*) FROM source.consent WHERE run_id = r.old_id) "
      "OR r.answers < (SELECT count(*) FROM source.answer WHERE run_id = r.old_id) "
      "OR r.events < (SELECT count(*) FROM source.event WHERE run_id = r.old_id) "
      "OR EXISTS (SELECT 1 FROM source.trial AS st JOIN merged_trial AS m ON m.old_id = st.trial_id "
      "WHERE st.run_id = r.old_id AND (NOT m.known OR st.ending IS NOT NULL "
      "OR EXISTS (SELECT 1 FROM source.frame WHERE trial_id = m.old_id AND frame >= m.frames) "
      "OR EXISTS (SELECT 1 FROM source.input WHERE trial_id = m.old_id AND input_index >= m.inputs) "
      "OR EXISTS (SELECT 1 FROM source.gaze WHERE trial_id = m.old_id AND gaze_index >= m.gazes))))");
  return report;
}

/// Rows of a run that are only ever appended, and have no name of their own: those beyond the number that is known.
void appendRows(SQLite::Database& database, const std::string& table) {
  const std::string id = table + "_id";
  copyRows(database, table, {{id, ""}, {"run_id", "r.new_id"}},
           fmt::format("JOIN merged_run AS r ON r.old_id = s.run_id WHERE NOT r.known OR r.{0}s <= (SELECT count(*) "
                       "FROM source.{0} AS e WHERE e.run_id = s.run_id AND e.{1} < s.{1}) ORDER BY s.{1}",
                       table, id));
}

void endRunsAndTrials(SQLite::Database& database) {
  database.exec(
      "UPDATE main.run AS t SET ending = s.ending, ended_utc = s.ended_utc FROM source.run AS s "
      "JOIN merged_run AS r ON r.old_id = s.run_id "
      "WHERE r.known AND t.run_id = r.new_id AND t.ending IS NULL AND s.ending IS NOT NULL");
  const std::set<std::string> plan{"trial_id", "run_id",     "subject_id", "session_number", "trial_number",
                                   "practice", "plan_index", "attempt",    "block_index",    "block",
                                   "task",     "case_index", "view",       "trial_seed",     "simulated"};
  database.exec(
      fmt::format("UPDATE main.trial AS t SET {} FROM source.trial AS s JOIN merged_trial AS m ON m.old_id = "
                  "s.trial_id WHERE m.known AND t.trial_id = m.new_id AND s.ending IS NOT NULL",
                  columnsOf(database, "trial", plan, "{0} = s.{0}")));
}

void addRows(SQLite::Database& database) {
  const std::string notLeft = "s.subject_id NOT IN (SELECT subject_id FROM left_subject)";
  copyRows(database, "subject", {}, "WHERE s.subject_key NOT IN (SELECT subject_key FROM main.subject) AND " + notLeft);
  copyRows(database, "session", {},
           "WHERE (s.subject_id, s.session_number) NOT IN (SELECT subject_id, session_number FROM main.session) AND " +
               notLeft);
  const std::string ofRun = "JOIN merged_run AS r ON r.old_id = s.run_id";
  const std::string ofTrial = "JOIN merged_trial AS m ON m.old_id = s.trial_id";
  copyRows(database, "run", {{"run_id", "r.new_id"}}, ofRun + " WHERE NOT r.known");
  for (const char* table : {"consent", "answer", "event"}) {
    appendRows(database, table);
  }
  copyRows(database, "trial", {{"trial_id", "m.new_id"}, {"run_id", "r.new_id"}},
           ofRun + " " + ofTrial + " WHERE NOT m.known");
  copyRows(database, "frame", {{"trial_id", "m.new_id"}}, ofTrial + " WHERE s.frame >= m.frames");
  copyRows(database, "input", {{"trial_id", "m.new_id"}}, ofTrial + " WHERE s.input_index >= m.inputs");
  copyRows(database, "gaze", {{"trial_id", "m.new_id"}}, ofTrial + " WHERE s.gaze_index >= m.gazes");
  endRunsAndTrials(database);
}

}  // namespace

MergeReport addMissingRows(SQLite::Database& database, const fs::path& source, const std::set<std::string>& left) {
  SQLite::Statement attach(database, "ATTACH ? AS source");
  attach.bind(1, uriForReading(source));
  attach.exec();
  MergeReport report;
  {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    mapRows(database, left);
    report = countMissing(database);
    addRows(database);
    database.exec("DROP TABLE merged_trial; DROP TABLE merged_run; DROP TABLE left_subject");
    if (report.subjects > 0 || report.runs > 0 || report.runsThatWentOn > 0) {
      const nlohmann::ordered_json detail = {{"source", fs::absolute(source).string()},
                                             {"subjects", report.subjects},
                                             {"runs", report.runs},
                                             {"runs_that_went_on", report.runsThatWentOn},
                                             {"trials", report.trials}};
      addAudit(database, "merged", detail.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    }
    transaction.commit();
  }
  database.exec("DETACH source");
  return report;
}

}  // namespace ocelli
