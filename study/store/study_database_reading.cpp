// Reading the rows of a study's database.
#include <fmt/format.h>

#include <type_traits>

#include "oc_core/base/error.h"
#include "study/outline/condition_names.h"
#include "study/store/database_state.h"
#include "study/store/input_columns.h"
#include "study/trial/stored_row.h"

namespace ocelli {
namespace {

uint64_t bitsOf(StoredRow& row) {
  return static_cast<uint64_t>(row.integer());
}

/// All rows of a query, each through `read(row)`. `bind(statement)` gives its parameters.
template <class Read, class Bind>
auto rowsOf(SQLite::Database& database, const std::filesystem::path& path, const std::string& query, const Read& read,
            const Bind& bind) {
  return whileReading(path, [&] {
    std::vector<std::invoke_result_t<Read, StoredRow&>> rows;
    SQLite::Statement statement(database, query);
    bind(statement);
    while (statement.executeStep()) {
      StoredRow row(statement, path);
      rows.push_back(read(row));
    }
    return rows;
  });
}

constexpr auto kNothing = [](SQLite::Statement&) {};

auto bindSubject(const std::string& subject) {
  return [&subject](SQLite::Statement& statement) { statement.bind(1, subject); };
}

auto bindSession(const std::string& subject, int session) {
  return [&subject, session](SQLite::Statement& statement) {
    statement.bind(1, subject);
    statement.bind(2, session);
  };
}

// Fields are read in the order in which the query asks for them: as initialisers in braces are.

StoredSubject readSubject(StoredRow& row) {
  return {row.text(), row.word(kSubjectKinds), row.smallInteger(), row.text()};
}
constexpr const char* kSubjects = "SELECT subject_id, kind, slot, created_utc FROM subject ";

StoredSession readSession(StoredRow& row) {
  return {row.text(),         row.smallInteger(), row.text(),
          bitsOf(row),        row.text(),         row.smallInteger(),
          row.smallInteger(), row.smallInteger(), row.optionalWord(kSessionEndings),
          row.text()};
}
constexpr const char* kSessions =
    "SELECT session.subject_id, session.session_number, schedule_json, seed, session.started_utc, "
    "session.planned_trials, completed_trials, runs, ending, ended_utc FROM session "
    "JOIN session_state USING (subject_id, session_number) ";
constexpr const char* kSessionOrder = "ORDER BY session.subject_id, session.session_number";

StoredRun readRun(StoredRow& row) {
  StoredRun run;
  run.id = row.integer();
  run.record.subject = row.text();
  run.record.session = row.smallInteger();
  run.record.startedUtc = row.text();
  run.endedUtc = row.text();
  run.ending = row.optionalWord(kSessionEndings);
  run.record.programVersion = row.text();
  run.record.station = row.text();
  run.record.environment = row.text();
  run.record.timingCheck = row.text();
  run.record.forced = row.flag();
  run.record.simulation = row.text();
  run.record.kind = row.word(kSubjectKinds);
  run.record.slot = row.smallInteger();
  return run;
}

/// With the kind of its subject.
std::string trialsQuery(const std::string& rest) {
  return fmt::format(
      "SELECT {} FROM (SELECT trial.*, subject.kind AS subject_kind FROM trial JOIN subject USING (subject_id)) {}",
      trialColumns("subject_kind"), rest);
}

FrameRecord readFrame(StoredRow& row) {
  FrameRecord frame{row.integer(), row.integer(), row.integer(), {row.real(), row.real(), row.real()}};
  if (const std::optional<int64_t> hash = row.optionalInteger()) {
    frame.pixelHash = static_cast<uint64_t>(*hash);
  }
  return frame;
}

InputRecord readInput(StoredRow& row) {
  InputRecord input;
  input.tick = row.integer();
  input.nanoseconds = row.integer();
  const InputColumns columns{row.text(),         row.optionalText(), row.optionalFlag(), row.optionalSmallInteger(),
                             row.optionalReal(), row.optionalReal(), row.optionalText()};
  const std::optional<InputEvent> event = eventOf(columns);
  if (!event) {
    row.failAtLast("stands in a row that is no input");
  }
  input.event = *event;
  return input;
}

GazeRecord readGaze(StoredRow& row) {
  GazeRecord sample{row.integer(), row.real(), row.flag()};
  sample.x = row.optionalReal().value_or(0);
  sample.y = row.optionalReal().value_or(0);
  sample.pupil = row.optionalReal();
  return sample;
}

template <class Row>
std::optional<Row> firstOf(std::vector<Row> rows) {
  return rows.empty() ? std::nullopt : std::optional(std::move(rows.front()));
}

/// Reads trials of a database, whose protocol names the conditions.
auto trialReader(const StudyDatabase& database) {
  return [conditions = conditionNamesOf(database.study().protocolText, database.path().string())](StoredRow& row) {
    return readTrial(row, conditions);
  };
}

}  // namespace

StoredStudy StudyDatabase::study() const {
  const auto read = [](StoredRow& row) {
    return StoredStudy{row.text(), row.text(), row.text(), row.text(), row.text()};
  };
  const std::optional<StoredStudy> study = firstOf(rowsOf(
      state_->database, state_->path,
      "SELECT protocol_name, protocol_sha256, protocol_text, program_version, created_utc FROM study", read, kNothing));
  if (!study) {
    throw InputError("this database holds no study yet", state_->path.string(),
                     "start a session, which stores the protocol");
  }
  return *study;
}

std::vector<StoredSubject> StudyDatabase::subjects() const {
  return rowsOf(state_->database, state_->path, fmt::format("{} ORDER BY created_utc, rowid", kSubjects), readSubject,
                kNothing);
}

std::optional<StoredSubject> StudyDatabase::subject(const std::string& id) const {
  return firstOf(rowsOf(state_->database, state_->path, fmt::format("{} WHERE subject_id = ?", kSubjects), readSubject,
                        bindSubject(id)));
}

std::vector<StoredSession> StudyDatabase::sessions() const {
  return rowsOf(state_->database, state_->path, fmt::format("{} {}", kSessions, kSessionOrder), readSession, kNothing);
}

std::vector<StoredSession> StudyDatabase::sessions(const std::string& subject) const {
  return rowsOf(state_->database, state_->path,
                fmt::format("{} WHERE session.subject_id = ? {}", kSessions, kSessionOrder), readSession,
                bindSubject(subject));
}

std::optional<StoredSession> StudyDatabase::session(const std::string& subject, int session) const {
  return firstOf(rowsOf(state_->database, state_->path,
                        fmt::format("{} WHERE session.subject_id = ? AND session.session_number = ?", kSessions),
                        readSession, bindSession(subject, session)));
}

std::vector<StoredRun> StudyDatabase::runs(const std::string& subject, int session) const {
  return rowsOf(state_->database, state_->path,
                "SELECT run_id, subject_id, session_number, started_utc, ended_utc, ending, program_version, station, "
                "environment_json, timing_check_json, forced, simulation_json, kind, slot FROM run "
                "JOIN subject USING (subject_id) WHERE subject_id = ? AND session_number = ? ORDER BY run_number",
                readRun, bindSession(subject, session));
}

std::vector<TrialRow> StudyDatabase::trials() const {
  return rowsOf(state_->database, state_->path, trialsQuery("ORDER BY trial_id"), trialReader(*this), kNothing);
}

std::vector<TrialRow> StudyDatabase::trials(const std::string& subject) const {
  return rowsOf(state_->database, state_->path, trialsQuery("WHERE subject_id = ? ORDER BY trial_id"),
                trialReader(*this), bindSubject(subject));
}

std::vector<TrialRow> StudyDatabase::trials(const std::string& subject, int session) const {
  return rowsOf(state_->database, state_->path,
                trialsQuery("WHERE subject_id = ? AND session_number = ? ORDER BY trial_id"), trialReader(*this),
                bindSession(subject, session));
}

TrialRow StudyDatabase::trial(int64_t id) const {
  std::optional<TrialRow> trial =
      firstOf(rowsOf(state_->database, state_->path, trialsQuery("WHERE trial_id = ?"), trialReader(*this),
                     [id](SQLite::Statement& statement) { statement.bind(1, id); }));
  if (!trial) {
    throw InputError(fmt::format("there is no trial {}", id), state_->path.string(),
                     "`ocelli study export` lists the trials with their numbers");
  }
  return std::move(*trial);
}

std::vector<FrameRecord> StudyDatabase::frames(int64_t trial) const {
  return rowsOf(state_->database, state_->path,
                "SELECT frame, tick, shown_ns, x_m, z_m, heading_rad, pixel_hash FROM frame WHERE trial_id = ? "
                "ORDER BY frame",
                readFrame, [trial](SQLite::Statement& statement) { statement.bind(1, trial); });
}

std::vector<InputRecord> StudyDatabase::inputs(int64_t trial) const {
  return rowsOf(state_->database, state_->path,
                "SELECT tick, came_ns, kind, what, pressed, modifiers, x, y, more_json FROM input WHERE trial_id = ? "
                "ORDER BY input_index",
                readInput, [trial](SQLite::Statement& statement) { statement.bind(1, trial); });
}

std::vector<GazeRecord> StudyDatabase::gaze(int64_t trial) const {
  return rowsOf(state_->database, state_->path,
                "SELECT came_ns, device_time, valid, x_px, y_px, pupil FROM gaze WHERE trial_id = ? "
                "ORDER BY gaze_index",
                readGaze, [trial](SQLite::Statement& statement) { statement.bind(1, trial); });
}

std::vector<StoredAnswer> StudyDatabase::answers(const std::string& subject) const {
  const auto read = [](StoredRow& row) {
    return StoredAnswer{row.smallInteger(), {row.text(), row.text(), row.text(), row.text()}};
  };
  return rowsOf(state_->database, state_->path,
                "SELECT session_number, form, field, answer, answered_utc FROM answer WHERE subject_id = ? "
                "ORDER BY answer_id",
                read, bindSubject(subject));
}

std::vector<StoredConsent> StudyDatabase::consents(const std::string& subject) const {
  const auto read = [](StoredRow& row) {
    return StoredConsent{row.smallInteger(), {row.text(), row.text(), row.text(), row.flag(), row.text()}};
  };
  return rowsOf(state_->database, state_->path,
                "SELECT session_number, title, text, text_sha256, agreed, answered_utc FROM consent "
                "WHERE subject_id = ? ORDER BY consent_id",
                read, bindSubject(subject));
}

std::vector<StoredEvent> StudyDatabase::events(const std::string& subject) const {
  const auto read = [](StoredRow& row) {
    return StoredEvent{row.integer(), row.smallInteger(), {row.integer(), row.text(), row.text(), row.text()}};
  };
  return rowsOf(state_->database, state_->path,
                "SELECT run_id, session_number, at_ns, at_utc, what, detail FROM event WHERE subject_id = ? "
                "ORDER BY event_id",
                read, bindSubject(subject));
}

std::vector<AuditEntry> StudyDatabase::audit() const {
  const auto read = [](StoredRow& row) { return AuditEntry{row.text(), row.text(), row.text()}; };
  return rowsOf(state_->database, state_->path, "SELECT at_utc, action, detail_json FROM audit ORDER BY audit_id", read,
                kNothing);
}

}  // namespace ocelli
