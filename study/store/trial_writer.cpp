#include "study/store/trial_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "study/session/trial_rows.h"
#include "study/store/input_columns.h"

namespace ocelli {
namespace {

// SQLite's whole numbers have a sign.
int64_t withSign(uint64_t bits) {
  return static_cast<int64_t>(bits);
}

std::string jsonOf(const std::map<std::string, double>& measures) {
  nlohmann::json json = nlohmann::json::object();
  for (const auto& [name, value] : measures) {
    if (std::isfinite(value)) {  // JSON knows no other numbers
      json[name] = value;
    }
  }
  return json.dump();
}

/// Binds the fields of a row to parameters, one after the other.
class FieldBinder {
 public:
  /// What is bound must live until the statement is executed.
  FieldBinder(SQLite::Statement& statement, int first, const ViewConditions& conditions)
      : statement_(statement), next_(first), conditions_(conditions) {}

  void skip() { ++next_; }
  void bind(int value) { statement_.bind(next_++, value); }
  void bind(int64_t value) { statement_.bind(next_++, value); }
  void bind(double value) { statement_.bind(next_++, value); }
  void bind(bool value) { statement_.bind(next_++, value ? 1 : 0); }
  void bind(uint64_t bits) { statement_.bind(next_++, withSign(bits)); }
  void bind(const std::string& value) { statement_.bindNoCopy(next_++, value); }
  void bind(const char* value) { statement_.bind(next_++, value); }
  void bind(const std::map<std::string, double>& measures) { statement_.bind(next_++, jsonOf(measures)); }
  void bind(TrialView view) { bind(conditions_.nameOf(view)); }
  void bind(TrialEnding ending) { bind(nameOf(ending)); }
  void bind(TimingVerdict verdict) { bind(nameOf(verdict)); }
  void bind(ExposureRule rule) { bind(nameOf(rule)); }
  template <class Value>
  void bind(const std::optional<Value>& value) {
    if (value) {
      bind(*value);
    } else {
      statement_.bind(next_++);
    }
  }

 private:
  SQLite::Statement& statement_;
  int next_;
  const ViewConditions& conditions_;
};

/// "INSERT INTO trial (run_id, ..., trial_seed) VALUES (?, ...)", after run, subject, session and mark.
std::string insertOfTrial() {
  std::string columns = "run_id, subject_id, session_number, simulated";
  std::string values = "?, ?, ?, ?";
  const TrialRow any;
  forEachPlanColumn(any, [&](const char* name, const auto&) {
    columns.append(", ").append(name);
    values += ", ?";
  });
  return fmt::format("INSERT INTO trial ({}) VALUES ({})", columns, values);
}

/// "UPDATE trial SET ending = ?, ... WHERE trial_id = ?1", from parameter 2 on.
std::string updateOfTrial() {
  std::string columns;
  int parameter = 2;
  const auto add = [&](const char* name, const auto&) {
    columns += fmt::format("{}{} = ?{}", columns.empty() ? "" : ", ", name, parameter++);
  };
  const TrialRow any;
  forEachCaseColumn(any, add);
  forEachOutcomeColumn(any, add);
  forEachTimingColumn(any, add);
  return fmt::format("UPDATE trial SET {} WHERE trial_id = ?1", columns);
}

void execute(SQLite::Statement& statement) {
  statement.exec();
  statement.reset();
}

}  // namespace

TrialWriter::TrialWriter(SQLite::Database& database, int64_t runId, RunRecord run, std::vector<std::string> blocks,
                         ViewConditions conditions)
    : database_(database),
      runId_(runId),
      run_(std::move(run)),
      simulated_(isSimulated(run_.kind) ? 1 : 0),
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
      trialBegins_(database, insertOfTrial()),
      frame_(database,
             "INSERT INTO frame (trial_id, frame, tick, shown_ns, x_m, z_m, heading_rad, pixel_hash, simulated) "
             "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      input_(database,
             "INSERT INTO input (trial_id, input_index, tick, came_ns, kind, what, pressed, modifiers, x, y, "
             "more_json, simulated) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      gaze_(database,
            "INSERT INTO gaze (trial_id, gaze_index, came_ns, device_time, valid, x_px, y_px, pupil, simulated) "
            "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      trialEnds_(database, updateOfTrial()),
      sessionEnds_(database, "UPDATE run SET ending = ?2, ended_utc = ?3 WHERE run_id = ?1 AND ending IS NULL") {}

void TrialWriter::write(const StoreMessage& message) {
  std::visit([this](const auto& what) { write(what); }, message);
}

void TrialWriter::reset() noexcept {
  for (SQLite::Statement* statement :
       {&consent_, &answer_, &event_, &trialBegins_, &frame_, &input_, &gaze_, &trialEnds_, &sessionEnds_}) {
    statement->tryReset();
  }
}

std::optional<int64_t> TrialWriter::idOf(int trial) const {
  const auto found = trials_.find(trial);
  return found == trials_.end() ? std::nullopt : std::optional(found->second);
}

void TrialWriter::begin(SQLite::Statement& statement) const {
  statement.bind(1, runId_);
  statement.bindNoCopy(2, run_.subject);
  statement.bind(3, run_.session);
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
  const TrialRow row = ocelli::rowOf(run_, message.number, message.plan, message.attempt,
                                     blocks_.at(static_cast<size_t>(message.plan.block)));
  begin(trialBegins_);
  FieldBinder binder(trialBegins_, 5, conditions_);
  forEachPlanColumn(row, [&](const char*, const auto& field) {
    if (static_cast<const void*>(&field) == &row.planIndex) {
      binder.bind(row.practice ? std::nullopt : std::optional(row.planIndex));
    } else {
      binder.bind(field);
    }
  });
  execute(trialBegins_);
  trials_[message.number] = database_.getLastInsertRowid();
}

void TrialWriter::write(const TrialFrames& message) {
  const std::optional<int64_t> trial = idOf(message.number);
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
  const std::optional<int64_t> trial = idOf(message.number);
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

void TrialWriter::write(const TrialGaze& message) {
  const std::optional<int64_t> trial = idOf(message.number);
  if (!trial) {
    return;
  }
  gaze_.bind(1, *trial);
  gaze_.bind(9, simulated_);
  int64_t index = message.firstIndex;
  for (const GazeRecord& record : message.records) {
    gaze_.bind(2, index++);
    gaze_.bind(3, record.nanoseconds);
    gaze_.bind(4, record.deviceTime);
    gaze_.bind(5, record.valid ? 1 : 0);
    // Where a tracker saw no eye, what it sends as a place is none.
    bindOptional(gaze_, 6, record.valid ? std::optional(record.x) : std::nullopt);
    bindOptional(gaze_, 7, record.valid ? std::optional(record.y) : std::nullopt);
    bindOptional(gaze_, 8, record.pupil);
    execute(gaze_);
  }
}

void TrialWriter::write(const TrialEnds& message) {
  const std::optional<int64_t> trial = idOf(message.number);
  if (!trial) {
    throw std::runtime_error("a trial ends whose beginning was not stored");
  }
  TrialRow row;
  addEnd(row, message.record);
  trialEnds_.clearBindings();
  trialEnds_.bind(1, *trial);
  FieldBinder binder(trialEnds_, 2, conditions_);
  const auto bind = [&](const char*, const auto& field) { binder.bind(field); };
  forEachCaseColumn(row, bind);
  forEachOutcomeColumn(row, [&](const char*, const auto& field) {
    if (row.ending == TrialEnding::kCompleted) {
      binder.bind(field);
    } else {
      binder.skip();  // NULL
    }
  });
  forEachTimingColumn(row, bind);
  execute(trialEnds_);
}

void TrialWriter::write(const SessionEnds& message) {
  sessionEnds_.bind(1, runId_);
  sessionEnds_.bind(2, nameOf(message.ending));
  sessionEnds_.bindNoCopy(3, message.utc);
  execute(sessionEnds_);
}

}  // namespace ocelli
