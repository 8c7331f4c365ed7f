#include "analysis/dataset/database.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "analysis/dataset/protocol_facts.h"
#include "analysis/dataset/row_digest.h"
#include "analysis/dataset/sqlite_reading.h"
#include "analysis/dataset/trial_check.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// The columns of a row of a statement, by the order in which they are asked for. Each throws InputError for what is
/// no such value.
class Row {
 public:
  Row(SQLite::Statement& statement, const std::string& path) : statement_(statement), path_(path) {}

  /// NULL is empty.
  std::string text() {
    const SQLite::Column column = next();
    if (!column.isText() && !column.isNull()) {
      fail(column, "is no text");
    }
    return column.getString();
  }
  std::string name() {
    const std::string value = text();
    if (const std::string problem = problemOfName(value); !problem.empty()) {
      fail(statement_.getColumn(column_ - 1), problem);
    }
    return value;
  }
  int64_t integer() {
    const SQLite::Column column = next();
    if (!column.isInteger()) {
      fail(column, "must be a whole number");
    }
    return column.getInt64();
  }
  int smallInteger() {
    const int64_t value = integer();
    if (value < 0 || value > std::numeric_limits<int>::max()) {
      fail(statement_.getColumn(column_ - 1),
           fmt::format("is {}, but must be from 0 to {}", value, std::numeric_limits<int>::max()));
    }
    return static_cast<int>(value);
  }
  bool flag() { return smallInteger() != 0; }
  std::optional<int64_t> optionalInteger() { return isNull() ? skipped<int64_t>() : integer(); }
  std::optional<int> optionalSmallInteger() { return isNull() ? skipped<int>() : smallInteger(); }
  std::optional<bool> optionalFlag() { return isNull() ? skipped<bool>() : flag(); }
  std::optional<double> optionalReal() {
    const SQLite::Column column = next();
    if (column.isNull()) {
      return std::nullopt;
    }
    if (!column.isFloat() && !column.isInteger()) {
      fail(column, "must be a number");
    }
    return column.getDouble();
  }
  [[noreturn]] void fail(const std::string& column, const std::string& problem) {
    const SQLite::Column first = statement_.getColumn(0);
    throw InputError(fmt::format("{} {}", column, problem),
                     fmt::format("{}, {} {}", path_, first.getName(), first.getString()),
                     "the database as the study wrote it");
  }

 private:
  SQLite::Column next() { return statement_.getColumn(column_++); }
  bool isNull() { return statement_.getColumn(column_).isNull(); }
  template <class Value>
  std::optional<Value> skipped() {
    ++column_;
    return std::nullopt;
  }
  [[noreturn]] void fail(const SQLite::Column& column, const std::string& problem) { fail(column.getName(), problem); }

  SQLite::Statement& statement_;
  const std::string& path_;
  int column_ = 0;
};

class DatabaseReading {
 public:
  explicit DatabaseReading(const std::string& path) : path_(path), database_(openStudyForReading(path)) {}

  Dataset all() {
    return withSqliteErrors(path_, [&] {
      // One moment for all tables, whatever is written meanwhile.
      SQLite::Transaction transaction(database_);
      checkIntegrity(database_, path_);
      readStudy();
      readSubjects();
      readSessions();
      readRuns();
      readConsents();
      readAnswers();
      readTrials();
      readOtherAttempts();
      return std::move(data_);
    });
  }

 private:
  template <class Read>
  void forEachRow(const char* query, const Read& read) {
    SQLite::Statement statement(database_, query);
    while (statement.executeStep()) {
      Row row(statement, path_);
      read(row);
    }
  }
  void readStudy();
  std::vector<WithdrawnKey> readWithdrawals();
  void readSubjects();
  void readSessions();
  void readRuns();
  void readConsents();
  void readAnswers();
  void readTrials();
  void readOtherAttempts();
  Trial trialOf(Row& row) const;
  std::map<std::string, double> measuresOf(const std::string& text, int64_t trial) const;

  std::string path_;
  SQLite::Database database_;
  Dataset data_{};
};

void DatabaseReading::readStudy() {
  DataSource source;
  source.path = path_;
  forEachRow("SELECT protocol_name, protocol_sha256, protocol_text, program_version FROM study", [&](Row& row) {
    source.protocolName = row.text();
    source.protocolSha256 = row.text();
    source.protocolText = row.text();
    source.programVersion = row.text();
  });
  if (source.protocolSha256.empty()) {
    throw InputError("this database holds no study yet", path_,
                     "again when a session has begun, which stores the protocol");
  }
  if (sha256(source.protocolText) != source.protocolSha256) {
    throw InputError(
        "the protocol in this database does not have the SHA-256 that stands beside it: someone changed it", path_,
        "the database as the study wrote it");
  }
  source.withdrawals = readWithdrawals();
  data_.conditions = protocolFacts(source.protocolText, fmt::format("{}, protocol", path_)).conditions;
  data_.sources.push_back(std::move(source));
}

std::vector<WithdrawnKey> DatabaseReading::readWithdrawals() {
  std::vector<WithdrawnKey> withdrawals;
  forEachRow("SELECT detail_json FROM audit WHERE action = 'withdrawn' ORDER BY audit_id", [&](Row& row) {
    const nlohmann::json detail = nlohmann::json::parse(row.text(), nullptr, false);
    if (detail.is_object() && detail.value("salt", nlohmann::json()).is_string() &&
        detail.value("subject_key_sha256", nlohmann::json()).is_string()) {
      withdrawals.push_back({detail["salt"].get<std::string>(), detail["subject_key_sha256"].get<std::string>()});
    }
  });
  return withdrawals;
}

void DatabaseReading::readSubjects() {
  forEachRow("SELECT subject_id, subject_key, kind, simulated, slot, created_utc FROM subject ORDER BY subject_id",
             [&](Row& row) {
               Subject subject;
               subject.id = row.name();
               subject.key = row.text();
               subject.kind = row.text();
               subject.simulated = row.flag();
               subject.slot = row.smallInteger();
               subject.createdUtc = row.text();
               data_.subjects.push_back(std::move(subject));
             });
}

void DatabaseReading::readSessions() {
  forEachRow(
      "SELECT subject_id, session_number, simulated, planned_trials, completed_trials, runs, ending, "
      "(SELECT max(forced) FROM run WHERE run.subject_id = session_state.subject_id "
      "AND run.session_number = session_state.session_number) "
      "FROM session_state ORDER BY subject_id, session_number",
      [&](Row& row) {
        Session session;
        session.subject = row.name();
        session.number = row.smallInteger();
        session.simulated = row.flag();
        session.plannedTrials = row.smallInteger();
        session.completedTrials = row.smallInteger();
        session.runs = row.smallInteger();
        session.ending = row.text();
        session.forced = row.optionalFlag().value_or(false);
        data_.sessions.push_back(std::move(session));
      });
}

void DatabaseReading::readRuns() {
  forEachRow(
      "SELECT subject_id, session_number, run_number, station, forced, simulated, environment_json, timing_check_json "
      "FROM run ORDER BY run_id",
      [&](Row& row) {
        Run run;
        run.subject = row.name();
        run.session = row.smallInteger();
        run.number = row.smallInteger();
        run.station = row.text();
        run.forced = row.flag();
        run.simulated = row.flag();
        run.environment = row.text();
        run.timingCheck = row.text();
        data_.runs.push_back(std::move(run));
      });
}

void DatabaseReading::readConsents() {
  forEachRow("SELECT subject_id, session_number, agreed FROM consent ORDER BY consent_id", [&](Row& row) {
    Consent consent;
    consent.subject = row.name();
    consent.session = row.smallInteger();
    consent.agreed = row.flag();
    data_.consents.push_back(std::move(consent));
  });
}

void DatabaseReading::readAnswers() {
  forEachRow(
      "SELECT answer_id, subject_id, session_number, form, field, answer, simulated FROM final_answer "
      "ORDER BY answer_id",
      [&](Row& row) {
        FormAnswer answer;
        answer.answerId = row.integer();
        answer.subject = row.name();
        answer.session = row.smallInteger();
        answer.form = row.name();
        answer.field = row.name();
        answer.answer = row.text();
        answer.simulated = row.flag();
        data_.answers.push_back(std::move(answer));
      });
}

std::map<std::string, double> DatabaseReading::measuresOf(const std::string& text, int64_t trial) const {
  std::map<std::string, double> measures;
  if (text.empty() || text == "{}") {
    return measures;
  }
  const auto fail = [&](const char* what) {
    throw InputError(what, fmt::format("{}, trial_id {}, measures_json", path_, trial),
                     "the database as the study wrote it");
  };
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) {
    fail("this is no JSON object");
  }
  for (const auto& [name, value] : json.items()) {
    if (!value.is_number()) {
      fail("a measure of this object is no number");
    }
    measures[name] = value.get<double>();
  }
  return measures;
}

constexpr const char* kTrialQuery =
    "SELECT trial_id, subject_id, session_number, plan_index, block_index, block, task, case_index, case_label, view, "
    "attempt, simulated, subject_kind, moving, exposure_s, objects, duplicate_colors, longest_s, answer, expected, "
    "correct, censored, response_s, measures_json, frames, dropped_frames, timing_verdict, "
    "trial_number, trial_seed, started_ns, ended_ns, started_utc, ended_utc, response_ticks, exposure_frames, "
    "median_interval_ns, longest_interval_ns, screen_width_px, screen_height_px, refresh_hz FROM final_trial "
    "ORDER BY trial_id";

Trial DatabaseReading::trialOf(Row& row) const {
  Trial trial;
  trial.trialId = row.integer();
  trial.subject = row.name();
  trial.session = row.smallInteger();
  trial.planIndex = row.smallInteger();
  trial.blockIndex = row.smallInteger();
  trial.block = row.name();
  trial.task = row.name();
  trial.caseIndex = row.smallInteger();
  trial.caseLabel = row.name();
  const std::string view = row.text();
  const std::optional<TrialView> condition = data_.conditions.viewNamed(view);
  if (!condition) {
    row.fail("view", fmt::format("is \"{}\", but {}", view, data_.conditions.mustBe()));
  }
  trial.view = *condition;
  trial.attempt = row.smallInteger();
  trial.simulated = row.flag();
  trial.subjectKind = row.text();
  trial.moving = row.optionalFlag();
  trial.exposureSeconds = row.optionalReal();
  trial.objects = row.optionalSmallInteger();
  trial.duplicateColors = row.optionalFlag();
  trial.longestSeconds = row.optionalReal();
  trial.answer = row.text();
  trial.expected = row.text();
  trial.correct = row.optionalFlag();
  trial.censored = row.optionalFlag();
  trial.responseSeconds = row.optionalReal();
  trial.measures = measuresOf(row.text(), trial.trialId);
  trial.frames = row.optionalInteger().value_or(0);
  trial.droppedFrames = row.optionalInteger().value_or(0);
  trial.timingVerdict = row.text();
  if (const auto problem = problemOf(trial)) {
    row.fail(problem->column, problem->problem);
  }
  UnreadColumns unread;
  unread.trialNumber = row.integer();
  unread.trialSeed = row.optionalInteger();
  unread.startedNs = row.optionalInteger();
  unread.endedNs = row.optionalInteger();
  unread.startedUtc = row.text();
  unread.endedUtc = row.text();
  unread.responseTicks = row.optionalInteger();
  unread.exposureFrames = row.optionalInteger();
  unread.medianIntervalNs = row.optionalInteger();
  unread.longestIntervalNs = row.optionalInteger();
  trial.screenWidth = row.optionalInteger();
  trial.screenHeight = row.optionalInteger();
  trial.refreshHertz = row.optionalReal();
  trial.digest = digestOf(trial, view, unread);
  return trial;
}

void DatabaseReading::readTrials() {
  forEachRow(kTrialQuery, [&](Row& row) { data_.trials.push_back(trialOf(row)); });
}

void DatabaseReading::readOtherAttempts() {
  forEachRow(
      "SELECT trial_id, subject_id, session_number, block_index, block, simulated, practice, ending, correct "
      "FROM trial WHERE practice = 1 OR ending IS NOT 'completed' OR trial_id NOT IN (SELECT trial_id FROM "
      "final_trial) "
      "ORDER BY trial_id",
      [&](Row& row) {
        OtherAttempt attempt;
        attempt.trialId = row.integer();
        attempt.subject = row.name();
        attempt.session = row.smallInteger();
        attempt.blockIndex = row.smallInteger();
        attempt.block = row.name();
        attempt.simulated = row.flag();
        const bool practice = row.flag();
        attempt.why = whyNotCounted(practice, row.text());
        attempt.correct = row.optionalFlag();
        data_.otherAttempts.push_back(std::move(attempt));
      });
}

}  // namespace

Dataset readDatabase(const std::string& path) {
  return DatabaseReading(path).all();
}

}  // namespace ocelli
