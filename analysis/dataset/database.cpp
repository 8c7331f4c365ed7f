#include "analysis/dataset/database.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "analysis/base/analysis_error.h"
#include "analysis/dataset/row_digest.h"
#include "analysis/dataset/sqlite_reading.h"

namespace ocelli {
namespace {

/// The columns of a row of a statement, by the order in which they are asked for.
class Row {
 public:
  explicit Row(SQLite::Statement& statement) : statement_(statement) {}

  std::string text() { return next().getString(); }
  int64_t integer() { return next().getInt64(); }
  int smallInteger() { return static_cast<int>(integer()); }
  bool flag() { return integer() != 0; }
  std::optional<int64_t> optionalInteger() {
    const SQLite::Column column = next();
    return column.isNull() ? std::nullopt : std::optional(column.getInt64());
  }
  std::optional<bool> optionalFlag() {
    const auto value = optionalInteger();
    return value ? std::optional(*value != 0) : std::nullopt;
  }
  std::optional<double> optionalReal() {
    const SQLite::Column column = next();
    return column.isNull() ? std::nullopt : std::optional(column.getDouble());
  }

 private:
  SQLite::Column next() { return statement_.getColumn(column_++); }

  SQLite::Statement& statement_;
  int column_ = 0;
};

class Reading {
 public:
  explicit Reading(const std::string& path) : path_(path), database_(openStudyForReading(path)) {}

  Dataset all() {
    return withSqliteErrors(path_, [&] {
      // One moment for all tables, whatever is written meanwhile.
      SQLite::Transaction transaction(database_);
      readStudy();
      readSubjects();
      readSessions();
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
      Row row(statement);
      read(row);
    }
  }
  void readStudy();
  void readSubjects();
  void readSessions();
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

void Reading::readStudy() {
  DataSource source;
  source.path = path_;
  forEachRow("SELECT protocol_name, protocol_sha256, protocol_text, program_version FROM study", [&](Row& row) {
    source.protocolName = row.text();
    source.protocolSha256 = row.text();
    source.protocolText = row.text();
    source.programVersion = row.text();
  });
  if (source.protocolSha256.empty()) {
    throw AnalysisError(AnalysisError::Kind::kInput, "this database holds no study yet", path_,
                        "again when a session has begun, which stores the protocol");
  }
  if (hexadecimal(sha256Of(source.protocolText)) != source.protocolSha256) {
    throw AnalysisError(
        AnalysisError::Kind::kInput,
        "the protocol in this database does not have the SHA-256 that stands beside it: someone changed it", path_,
        "the database as the study wrote it");
  }
  data_.sources.push_back(std::move(source));
}

void Reading::readSubjects() {
  forEachRow("SELECT subject_id, subject_key, kind, simulated, slot, created_utc FROM subject ORDER BY subject_id",
             [&](Row& row) {
               Subject subject;
               subject.id = row.text();
               subject.key = row.text();
               subject.kind = row.text();
               subject.simulated = row.flag();
               subject.slot = row.smallInteger();
               subject.createdUtc = row.text();
               data_.subjects.push_back(std::move(subject));
             });
}

void Reading::readSessions() {
  forEachRow(
      "SELECT subject_id, session_number, simulated, planned_trials, completed_trials, runs, ending, "
      "(SELECT max(forced) FROM run WHERE run.subject_id = session_state.subject_id "
      "AND run.session_number = session_state.session_number) "
      "FROM session_state ORDER BY subject_id, session_number",
      [&](Row& row) {
        Session session;
        session.subject = row.text();
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

void Reading::readConsents() {
  forEachRow("SELECT subject_id, session_number, agreed FROM consent ORDER BY consent_id", [&](Row& row) {
    Consent consent;
    consent.subject = row.text();
    consent.session = row.smallInteger();
    consent.agreed = row.flag();
    data_.consents.push_back(std::move(consent));
  });
}

void Reading::readAnswers() {
  forEachRow(
      "SELECT answer_id, subject_id, session_number, form, field, answer, simulated FROM final_answer "
      "ORDER BY answer_id",
      [&](Row& row) {
        FormAnswer answer;
        answer.answerId = row.integer();
        answer.subject = row.text();
        answer.session = row.smallInteger();
        answer.form = row.text();
        answer.field = row.text();
        answer.answer = row.text();
        answer.simulated = row.flag();
        data_.answers.push_back(std::move(answer));
      });
}

std::map<std::string, double> Reading::measuresOf(const std::string& text, int64_t trial) const {
  std::map<std::string, double> measures;
  if (text.empty() || text == "{}") {
    return measures;
  }
  const auto fail = [&](const char* what) {
    throw AnalysisError(AnalysisError::Kind::kInput, what, fmt::format("{}, trial_id {}, measures_json", path_, trial),
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

Trial Reading::trialOf(Row& row) const {
  Trial trial;
  trial.trialId = row.integer();
  trial.subject = row.text();
  trial.session = row.smallInteger();
  trial.planIndex = row.smallInteger();
  trial.blockIndex = row.smallInteger();
  trial.block = row.text();
  trial.task = row.text();
  trial.caseIndex = row.smallInteger();
  trial.caseLabel = row.text();
  trial.view = row.text() == nameOf(TrialView::kGraph) ? TrialView::kGraph : TrialView::kPinhole;
  trial.attempt = row.smallInteger();
  trial.simulated = row.flag();
  trial.subjectKind = row.text();
  trial.moving = row.optionalFlag();
  trial.exposureSeconds = row.optionalReal();
  if (const auto objects = row.optionalInteger()) {
    trial.objects = static_cast<int>(*objects);
  }
  trial.duplicateColors = row.optionalFlag();
  trial.longestSeconds = row.optionalReal();
  trial.answer = row.text();
  trial.expected = row.text();
  trial.correct = row.optionalFlag();
  trial.censored = row.optionalFlag();
  trial.responseSeconds = row.optionalReal();
  trial.measures = measuresOf(row.text(), trial.trialId);
  trial.frames = row.integer();
  trial.droppedFrames = row.integer();
  trial.timingVerdict = row.text();
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
  unread.screenWidth = row.optionalInteger();
  unread.screenHeight = row.optionalInteger();
  unread.refreshHertz = row.optionalReal();
  trial.digest = digestOf(trial, unread);
  return trial;
}

void Reading::readTrials() {
  forEachRow(kTrialQuery, [&](Row& row) { data_.trials.push_back(trialOf(row)); });
}

void Reading::readOtherAttempts() {
  forEachRow(
      "SELECT trial_id, subject_id, session_number, block_index, block, simulated, practice, ending, correct "
      "FROM trial WHERE practice = 1 OR ending IS NOT 'completed' OR trial_id NOT IN (SELECT trial_id FROM "
      "final_trial) "
      "ORDER BY trial_id",
      [&](Row& row) {
        OtherAttempt attempt;
        attempt.trialId = row.integer();
        attempt.subject = row.text();
        attempt.session = row.smallInteger();
        attempt.blockIndex = row.smallInteger();
        attempt.block = row.text();
        attempt.simulated = row.flag();
        const bool practice = row.flag();
        attempt.why = whyNotCounted(practice, row.text());
        attempt.correct = row.optionalFlag();
        data_.otherAttempts.push_back(std::move(attempt));
      });
}

}  // namespace

Dataset readDatabase(const std::string& path) {
  return Reading(path).all();
}

}  // namespace ocelli
