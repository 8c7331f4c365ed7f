#include "study/store/trial_writer.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "study/store/input_columns.h"

namespace ocelli {
namespace {

// SQLite's whole numbers have a sign.
int64_t withSign(uint64_t bits) {
  return static_cast<int64_t>(bits);
}

std::string jsonOf(const std::vector<std::pair<std::string, double>>& measures) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : measures) {
    json[name] = value;
  }
  return json.dump();
}

void execute(SQLite::Statement& statement) {
  statement.exec();
  statement.reset();
}

}  // namespace

TrialWriter::TrialWriter(SQLite::Database& database, int64_t run, const RunRecord& record,
                         std::vector<std::string> blocks, ViewConditions conditions)
    : database_(database),
      run_(run),
      subject_(record.subject),
      sessionNumber_(record.session + 1),
      simulated_(record.kind == SubjectKind::kPerson ? 0 : 1),
      blocks_(std::move(blocks)),
      conditions_(std::move(conditions)),
      consent_(database,
               "INSERT INTO consent (run_id, subject_id, session_number, simulated, title, text, text_sha256, agreed, "
               "answered_utc) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      answer_(database,
              "INSERT INTO answer (run_id, subject_id, session_number, simulated, form, field, answer, answered_utc) "
              "VALUES (?, ?, ?, ?, ?, ?, ?, ?)"),
      event_(database,
             "INSERT INTO event (run_id, subject_id, session_number, simulated, at_ns, at_utc, what, detail) "
             "VALUES (?, ?, ?, ?, ?, ?, ?, ?)"),
      trialBegins_(database,
                   "INSERT INTO trial (run_id, subject_id, session_number, simulated, trial_number, practice, "
                   "plan_index, attempt, block_index, block, task, case_index, view, trial_seed) "
                   "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      frame_(database,
             "INSERT INTO frame (trial_id, frame, tick, shown_ns, x_m, z_m, heading_rad, pixel_hash, simulated) "
             "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      input_(database,
             "INSERT INTO input (trial_id, input_index, tick, came_ns, kind, what, pressed, modifiers, x, y, "
             "more_json, simulated) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      trialEnds_(database,
                 "UPDATE trial SET ending = ?2, started_ns = ?3, ended_ns = ?4, started_utc = ?5, ended_utc = ?6, "
                 "case_label = ?7, moving = ?8, exposure_s = ?9, objects = ?10, duplicate_colors = ?11, "
                 "longest_s = ?12, typical_s = ?13, answer = ?14, expected = ?15, correct = ?16, censored = ?17, "
                 "response_s = ?18, response_ticks = ?19, exposure_frames = ?20, measures_json = ?21, frames = ?22, "
                 "dropped_frames = ?23, median_interval_ns = ?24, longest_interval_ns = ?25, timing_verdict = ?26, "
                 "screen_width_px = ?27, screen_height_px = ?28, refresh_hz = ?29 WHERE trial_id = ?1"),
      sessionEnds_(database, "UPDATE run SET ending = ?2, ended_utc = ?3 WHERE run_id = ?1 AND ending IS NULL") {}

void TrialWriter::write(const StoreMessage& message) {
  std::visit([this](const auto& what) { write(what); }, message);
}

void TrialWriter::reset() noexcept {
  for (SQLite::Statement* statement :
       {&consent_, &answer_, &event_, &trialBegins_, &frame_, &input_, &trialEnds_, &sessionEnds_}) {
    statement->tryReset();
  }
}

std::optional<int64_t> TrialWriter::rowOf(int trial) const {
  const auto found = trials_.find(trial);
  return found == trials_.end() ? std::nullopt : std::optional(found->second);
}

void TrialWriter::begin(SQLite::Statement& statement) const {
  statement.bind(1, run_);
  statement.bindNoCopy(2, subject_);
  statement.bind(3, sessionNumber_);
  statement.bind(4, simulated_);
}

void TrialWriter::write(const ConsentRecord& record) {
  begin(consent_);
  consent_.bindNoCopy(5, record.title);
  consent_.bindNoCopy(6, record.text);
  consent_.bindNoCopy(7, record.sha256);
  consent_.bind(8, record.agreed ? 1 : 0);
  consent_.bindNoCopy(9, record.utc);
  execute(consent_);
}

void TrialWriter::write(const AnswerRecord& record) {
  begin(answer_);
  answer_.bindNoCopy(5, record.form);
  answer_.bindNoCopy(6, record.field);
  answer_.bindNoCopy(7, record.answer);
  answer_.bindNoCopy(8, record.utc);
  execute(answer_);
}

void TrialWriter::write(const EventRecord& record) {
  begin(event_);
  event_.bind(5, record.nanoseconds);
  event_.bindNoCopy(6, record.utc);
  event_.bindNoCopy(7, record.what);
  event_.bindNoCopy(8, record.detail);
  execute(event_);
}

void TrialWriter::write(const TrialBegins& message) {
  const TrialPlan& plan = message.plan;
  begin(trialBegins_);
  trialBegins_.bind(5, message.number);
  trialBegins_.bind(6, plan.practice ? 1 : 0);
  bindOptional(trialBegins_, 7, plan.practice ? std::nullopt : std::optional(plan.index));
  trialBegins_.bind(8, message.attempt);
  trialBegins_.bind(9, plan.block);
  trialBegins_.bindNoCopy(10, blocks_.at(static_cast<size_t>(plan.block)));
  trialBegins_.bindNoCopy(11, plan.task);
  trialBegins_.bind(12, plan.caseIndex);
  trialBegins_.bindNoCopy(13, conditions_.nameOf(plan.view));
  trialBegins_.bind(14, withSign(plan.seed));
  execute(trialBegins_);
  trials_[message.number] = database_.getLastInsertRowid();
}

void TrialWriter::write(const TrialFrames& message) {
  const std::optional<int64_t> trial = rowOf(message.number);
  if (!trial) {
    return;
  }
  frame_.bind(1, *trial);
  frame_.bind(9, simulated_);
  for (const FrameRecord& frame : message.records) {
    frame_.bind(2, frame.frame);
    frame_.bind(3, frame.tick);
    frame_.bind(4, frame.shownNanoseconds);
    frame_.bind(5, frame.pose.x);
    frame_.bind(6, frame.pose.z);
    frame_.bind(7, frame.pose.headingRadians);
    bindOptional(frame_, 8, frame.pixelHash ? std::optional(withSign(*frame.pixelHash)) : std::nullopt);
    execute(frame_);
  }
}

void TrialWriter::write(const TrialInputs& message) {
  const std::optional<int64_t> trial = rowOf(message.number);
  if (!trial) {
    return;
  }
  input_.bind(1, *trial);
  input_.bind(12, simulated_);
  int64_t index = message.firstIndex;
  for (const InputRecord& record : message.records) {
    const InputColumns columns = columnsOf(record.event);
    input_.bind(2, index++);
    input_.bind(3, record.tick);
    input_.bind(4, record.nanoseconds);
    input_.bind(5, columns.kind);
    bindOptional(input_, 6, columns.what);
    bindOptional(input_, 7, columns.pressed);
    bindOptional(input_, 8, columns.modifiers);
    bindOptional(input_, 9, columns.x);
    bindOptional(input_, 10, columns.y);
    bindOptional(input_, 11, columns.moreJson);
    execute(input_);
  }
}

void TrialWriter::write(const TrialEnds& message) {
  const std::optional<int64_t> trial = rowOf(message.number);
  if (!trial) {
    throw std::runtime_error("a trial ends whose beginning was not stored");
  }
  const TrialRecord& record = message.record;
  SQLite::Statement& row = trialEnds_;
  row.clearBindings();
  row.bind(1, *trial);
  row.bind(2, nameOf(record.ending));
  row.bind(3, record.startedNanoseconds);
  row.bind(4, record.endedNanoseconds);
  row.bindNoCopy(5, record.startedUtc);
  row.bindNoCopy(6, record.endedUtc);
  row.bindNoCopy(7, record.info.label);
  row.bind(8, record.info.moving ? 1 : 0);
  bindOptional(row, 9, record.info.exposureSeconds);
  bindOptional(row, 10, record.info.objects);
  bindOptional(row, 11, record.info.duplicateColors);
  row.bind(12, record.info.longestSeconds);
  row.bind(13, record.info.typicalSeconds);
  if (record.ending == TrialEnding::kCompleted) {
    const TrialOutcome& outcome = record.outcome;
    row.bindNoCopy(14, outcome.answer);
    row.bindNoCopy(15, outcome.expected);
    row.bind(16, outcome.correct ? 1 : 0);
    row.bind(17, outcome.censored ? 1 : 0);
    row.bind(18, static_cast<double>(outcome.responseTicks) / static_cast<double>(kTicksPerSecond));
    row.bind(19, outcome.responseTicks);
    row.bind(20, outcome.exposureFrames);
    row.bind(21, jsonOf(outcome.measures));
  }
  row.bind(22, record.timing.frames);
  row.bind(23, record.timing.dropped);
  row.bind(24, record.timing.medianNanoseconds);
  row.bind(25, record.timing.longestNanoseconds);
  row.bindNoCopy(26, record.timing.verdict);
  row.bind(27, record.screen.width);
  row.bind(28, record.screen.height);
  row.bind(29, record.screen.refreshHertz);
  execute(row);
}

void TrialWriter::write(const SessionEnds& message) {
  sessionEnds_.bind(1, run_);
  sessionEnds_.bind(2, nameOf(message.ending));
  sessionEnds_.bindNoCopy(3, message.utc);
  execute(sessionEnds_);
}

}  // namespace ocelli
