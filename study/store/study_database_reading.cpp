// Reading the rows of a study's database.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "study/protocol/condition_fields.h"
#include "study/store/database_state.h"
#include "study/store/input_columns.h"

namespace ocelli {
namespace {

[[noreturn]] void throwUnknown(const std::string& what, const std::string& name) {
  throw WorkError(fmt::format("a row of this database holds an unknown {}", what), name,
                  "a newer version of ocelli, or the last backup");
}

template <class Value>
Value known(const std::optional<Value>& value, const std::string& what, const std::string& name) {
  if (!value) {
    throwUnknown(what, name);
  }
  return *value;
}

std::optional<SessionEnding> sessionEndingOf(const std::optional<std::string>& name) {
  if (!name) {
    return std::nullopt;
  }
  for (const SessionEnding ending : {SessionEnding::kCompleted, SessionEnding::kUnwell, SessionEnding::kAborted,
                                     SessionEnding::kDeclined, SessionEnding::kFailed}) {
    if (*name == nameOf(ending)) {
      return ending;
    }
  }
  throwUnknown("ending of a session", *name);
}

TrialEnding trialEndingOf(const std::string& name) {
  for (const TrialEnding ending : {TrialEnding::kCompleted, TrialEnding::kRedone, TrialEnding::kAborted}) {
    if (name == nameOf(ending)) {
      return ending;
    }
  }
  throwUnknown("ending of a trial", name);
}

std::vector<std::pair<std::string, double>> measuresOf(const std::string& text) {
  std::vector<std::pair<std::string, double>> measures;
  const auto json = nlohmann::ordered_json::parse(text, nullptr, false);
  if (json.is_object()) {
    for (const auto& [name, value] : json.items()) {
      measures.emplace_back(name, value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return measures;
}

uint64_t bitsOf(const SQLite::Statement& row, int column) {
  return static_cast<uint64_t>(row.getColumn(column).getInt64());
}

int numberOf(const SQLite::Statement& row, int column) {
  return row.getColumn(column).getInt();
}

int64_t integerOf(const SQLite::Statement& row, int column) {
  return row.getColumn(column).getInt64();
}

template <class Value>
std::optional<Value> castOf(const std::optional<int64_t>& value) {
  return value ? std::optional(static_cast<Value>(*value)) : std::nullopt;
}

/// All rows of a query, each through `read(row)`. `bind(statement)` gives its parameters.
template <class Read, class Bind>
auto rowsOf(SQLite::Database& database, const std::filesystem::path& path, const std::string& query, const Read& read,
            const Bind& bind) {
  return withSqliteErrors("read this database", path, [&] {
    std::vector<decltype(read(std::declval<const SQLite::Statement&>()))> rows;
    SQLite::Statement statement(database, query);
    bind(statement);
    while (statement.executeStep()) {
      rows.push_back(read(statement));
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
    statement.bind(2, session + 1);
  };
}

StoredSubject readSubject(const SQLite::Statement& row) {
  return {textOf(row, 0), known(subjectKindFromName(textOf(row, 1)), "kind of a subject", textOf(row, 1)),
          numberOf(row, 2), textOf(row, 3)};
}
constexpr const char* kSubjects = "SELECT subject_id, kind, slot, created_utc FROM subject ";

StoredSession readSession(const SQLite::Statement& row) {
  StoredSession session{textOf(row, 0), numberOf(row, 1) - 1, textOf(row, 2),   bitsOf(row, 3),
                        textOf(row, 4), numberOf(row, 5),     numberOf(row, 6), numberOf(row, 7)};
  session.ending = sessionEndingOf(optionalTextOf(row, 8));
  session.endedUtc = optionalTextOf(row, 9).value_or("");
  return session;
}
constexpr const char* kSessions =
    "SELECT session.subject_id, session.session_number, schedule_json, seed, session.started_utc, "
    "session.planned_trials, completed_trials, runs, ending, ended_utc FROM session "
    "JOIN session_state USING (subject_id, session_number) ";
constexpr const char* kSessionOrder = "ORDER BY session.subject_id, session.session_number";

StoredRun readRun(const SQLite::Statement& row) {
  StoredRun run{integerOf(row, 0), {}};
  run.record.subject = textOf(row, 1);
  run.record.session = numberOf(row, 2) - 1;
  run.record.startedUtc = textOf(row, 3);
  run.endedUtc = optionalTextOf(row, 4).value_or("");
  run.ending = sessionEndingOf(optionalTextOf(row, 5));
  run.record.programVersion = textOf(row, 6);
  run.record.station = textOf(row, 7);
  run.record.environment = textOf(row, 8);
  run.record.timingCheck = textOf(row, 9);
  run.record.forced = numberOf(row, 10) != 0;
  run.record.simulation = optionalTextOf(row, 11).value_or("");
  run.record.kind = known(subjectKindFromName(textOf(row, 12)), "kind of a subject", textOf(row, 12));
  run.record.slot = numberOf(row, 13);
  return run;
}

constexpr const char* kTrials =
    "SELECT trial_id, run_id, trial_number, subject_id, session_number, kind, practice, plan_index, attempt, "
    "block_index, block, task, case_index, view, trial_seed, ending, started_ns, ended_ns, started_utc, ended_utc, "
    "case_label, moving, exposure_s, objects, duplicate_colors, longest_s, typical_s, answer, expected, correct, "
    "censored, response_ticks, exposure_frames, measures_json, frames, dropped_frames, median_interval_ns, "
    "longest_interval_ns, timing_verdict, screen_width_px, screen_height_px, refresh_hz "
    "FROM trial JOIN subject USING (subject_id) ";

TrialPlan readPlan(const SQLite::Statement& row, const ViewConditions& conditions) {
  TrialPlan plan;
  plan.practice = numberOf(row, 6) != 0;
  plan.index = plan.practice ? -1 : numberOf(row, 7);
  plan.block = numberOf(row, 9);
  plan.task = textOf(row, 11);
  plan.caseIndex = numberOf(row, 12);
  plan.view = known(conditions.viewNamed(textOf(row, 13)), "view condition", textOf(row, 13));
  plan.seed = bitsOf(row, 14);
  return plan;
}

CaseInfo readCase(const SQLite::Statement& row) {
  CaseInfo info;
  info.label = textOf(row, 20);
  info.moving = numberOf(row, 21) != 0;
  info.exposureSeconds = optionalNumberOf(row, 22);
  info.objects = castOf<int>(optionalIntegerOf(row, 23));
  info.duplicateColors = castOf<bool>(optionalIntegerOf(row, 24));
  info.longestSeconds = row.getColumn(25).getDouble();
  info.typicalSeconds = row.getColumn(26).getDouble();
  return info;
}

TrialOutcome readOutcome(const SQLite::Statement& row) {
  TrialOutcome outcome;
  outcome.answer = textOf(row, 27);
  outcome.expected = textOf(row, 28);
  outcome.correct = numberOf(row, 29) != 0;
  outcome.censored = numberOf(row, 30) != 0;
  outcome.responseTicks = integerOf(row, 31);
  outcome.exposureFrames = integerOf(row, 32);
  outcome.measures = measuresOf(textOf(row, 33));
  return outcome;
}

StoredTrial readTrial(const SQLite::Statement& row, const ViewConditions& conditions) {
  StoredTrial trial;
  trial.id = integerOf(row, 0);
  trial.run = integerOf(row, 1);
  trial.number = numberOf(row, 2);
  trial.subject = textOf(row, 3);
  trial.session = numberOf(row, 4) - 1;
  trial.kind = known(subjectKindFromName(textOf(row, 5)), "kind of a subject", textOf(row, 5));
  trial.block = textOf(row, 10);
  trial.record.plan = readPlan(row, conditions);
  trial.record.attempt = numberOf(row, 8);
  trial.ended = !row.isColumnNull(15);
  if (!trial.ended) {
    return trial;
  }
  TrialRecord& record = trial.record;
  record.ending = trialEndingOf(textOf(row, 15));
  record.startedNanoseconds = integerOf(row, 16);
  record.endedNanoseconds = integerOf(row, 17);
  record.startedUtc = textOf(row, 18);
  record.endedUtc = textOf(row, 19);
  record.info = readCase(row);
  if (record.ending == TrialEnding::kCompleted) {
    record.outcome = readOutcome(row);
  }
  record.timing = {integerOf(row, 34), integerOf(row, 35), integerOf(row, 36), integerOf(row, 37), textOf(row, 38)};
  record.screen = {numberOf(row, 39), numberOf(row, 40), row.getColumn(41).getDouble()};
  return trial;
}

FrameRecord readFrame(const SQLite::Statement& row) {
  FrameRecord frame{integerOf(row, 0),
                    integerOf(row, 1),
                    integerOf(row, 2),
                    {row.getColumn(3).getDouble(), row.getColumn(4).getDouble(), row.getColumn(5).getDouble()}};
  if (!row.isColumnNull(6)) {
    frame.pixelHash = bitsOf(row, 6);
  }
  return frame;
}

InputRecord readInput(const SQLite::Statement& row) {
  const InputColumns columns{textOf(row, 2),
                             optionalTextOf(row, 3),
                             castOf<bool>(optionalIntegerOf(row, 4)),
                             castOf<int>(optionalIntegerOf(row, 5)),
                             optionalNumberOf(row, 6),
                             optionalNumberOf(row, 7),
                             optionalTextOf(row, 8)};
  return {integerOf(row, 1), integerOf(row, 0), known(eventOf(columns), "input", columns.kind)};
}

template <class Row>
std::optional<Row> firstOf(std::vector<Row> rows) {
  return rows.empty() ? std::nullopt : std::optional(std::move(rows.front()));
}

/// Reads trials of a database, whose protocol names the conditions.
auto trialReader(const StudyDatabase& database) {
  return [conditions = conditionNamesOf(database.study().protocolText, database.path().string())](
             const SQLite::Statement& row) { return readTrial(row, conditions); };
}

}  // namespace

StoredStudy StudyDatabase::study() const {
  const auto read = [](const SQLite::Statement& row) {
    return StoredStudy{textOf(row, 0), textOf(row, 1), textOf(row, 2), textOf(row, 3), textOf(row, 4)};
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

std::vector<StoredTrial> StudyDatabase::trials() const {
  return rowsOf(state_->database, state_->path, fmt::format("{} ORDER BY trial_id", kTrials), trialReader(*this),
                kNothing);
}

std::vector<StoredTrial> StudyDatabase::trials(const std::string& subject) const {
  return rowsOf(state_->database, state_->path, fmt::format("{} WHERE subject_id = ? ORDER BY trial_id", kTrials),
                trialReader(*this), bindSubject(subject));
}

std::vector<StoredTrial> StudyDatabase::trials(const std::string& subject, int session) const {
  return rowsOf(state_->database, state_->path,
                fmt::format("{} WHERE subject_id = ? AND session_number = ? ORDER BY trial_id", kTrials),
                trialReader(*this), bindSession(subject, session));
}

StoredTrial StudyDatabase::trial(int64_t id) const {
  std::optional<StoredTrial> trial =
      firstOf(rowsOf(state_->database, state_->path, fmt::format("{} WHERE trial_id = ?", kTrials), trialReader(*this),
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

std::vector<StoredAnswer> StudyDatabase::answers(const std::string& subject) const {
  const auto read = [](const SQLite::Statement& row) {
    return StoredAnswer{numberOf(row, 0) - 1, {textOf(row, 1), textOf(row, 2), textOf(row, 3), textOf(row, 4)}};
  };
  return rowsOf(state_->database, state_->path,
                "SELECT session_number, form, field, answer, answered_utc FROM answer WHERE subject_id = ? "
                "ORDER BY answer_id",
                read, bindSubject(subject));
}

std::vector<StoredConsent> StudyDatabase::consents(const std::string& subject) const {
  const auto read = [](const SQLite::Statement& row) {
    return StoredConsent{numberOf(row, 0) - 1,
                         {textOf(row, 1), textOf(row, 2), textOf(row, 3), numberOf(row, 4) != 0, textOf(row, 5)}};
  };
  return rowsOf(state_->database, state_->path,
                "SELECT session_number, title, text, text_sha256, agreed, answered_utc FROM consent "
                "WHERE subject_id = ? ORDER BY consent_id",
                read, bindSubject(subject));
}

std::vector<StoredEvent> StudyDatabase::events(const std::string& subject) const {
  const auto read = [](const SQLite::Statement& row) {
    return StoredEvent{
        integerOf(row, 0), numberOf(row, 1) - 1, {integerOf(row, 2), textOf(row, 3), textOf(row, 4), textOf(row, 5)}};
  };
  return rowsOf(state_->database, state_->path,
                "SELECT run_id, session_number, at_ns, at_utc, what, detail FROM event WHERE subject_id = ? "
                "ORDER BY event_id",
                read, bindSubject(subject));
}

std::vector<AuditEntry> StudyDatabase::audit() const {
  const auto read = [](const SQLite::Statement& row) {
    return AuditEntry{textOf(row, 0), textOf(row, 1), textOf(row, 2)};
  };
  return rowsOf(state_->database, state_->path, "SELECT at_utc, action, detail_json FROM audit ORDER BY audit_id", read,
                kNothing);
}

}  // namespace ocelli
