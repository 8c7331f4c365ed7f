#include "analysis/dataset/csv_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "analysis/dataset/csv_table.h"
#include "analysis/dataset/protocol_facts.h"
#include "analysis/dataset/row_digest.h"
#include "oc_core/base/error.h"
#include "study/outline/csv_cases.h"
#include "study/trial/trial_check.h"

namespace ocelli {
namespace {

constexpr double kTicksPerSecond = 240;

/// Columns of trials.csv that are the same for all tasks; the others are measures.
constexpr std::array<std::string_view, 45> kTrialColumns{"row_id",
                                                         "trial_id",
                                                         "subject_id",
                                                         "simulated",
                                                         "subject_kind",
                                                         "slot",
                                                         "session_number",
                                                         "run_id",
                                                         "trial_number",
                                                         "counts",
                                                         "practice",
                                                         "plan_index",
                                                         "attempt",
                                                         "block_index",
                                                         "block",
                                                         "task",
                                                         "case_index",
                                                         "case_label",
                                                         "view",
                                                         "moving",
                                                         "exposure_s",
                                                         "objects",
                                                         "duplicate_colors",
                                                         "ending",
                                                         "answer",
                                                         "expected",
                                                         "correct",
                                                         "censored",
                                                         "response_s",
                                                         "exposure_frames",
                                                         "frames",
                                                         "dropped_frames",
                                                         "median_interval_ns",
                                                         "longest_interval_ns",
                                                         "timing_verdict",
                                                         "forced",
                                                         "screen_width_px",
                                                         "screen_height_px",
                                                         "refresh_hz",
                                                         "trial_seed",
                                                         "started_ns",
                                                         "ended_ns",
                                                         "started_utc",
                                                         "ended_utc",
                                                         "station"};

/// Reads a column of a row into a field of a trial, whose type says which values it may have.
class TrialFields {
 public:
  TrialFields(const CsvTable& table, const ViewConditions& conditions, bool conditionsAreKnown)
      : table_(table), conditions_(conditions), conditionsAreKnown_(conditionsAreKnown) {}

  void read(size_t column, std::string& field) const { field = table_.text(column); }
  void read(size_t column, int& field) const { field = table_.smallInteger(column); }
  void read(size_t column, int64_t& field) const { field = table_.optionalInteger(column).value_or(0); }
  void read(size_t column, bool& field) const { field = table_.flag(column); }
  void read(size_t column, std::optional<bool>& field) const { field = table_.optionalFlag(column); }
  void read(size_t column, std::optional<int64_t>& field) const { field = table_.optionalInteger(column); }
  void read(size_t column, std::optional<double>& field) const { field = table_.optionalReal(column); }
  void read(size_t column, std::optional<uint64_t>& field) const { field = table_.optionalHexadecimal(column); }
  void read(size_t column, std::optional<int>& field) const {
    if (table_.optionalInteger(column)) {
      field = table_.smallInteger(column);
    }
  }
  void read(size_t column, std::optional<TrialEnding>& field) const {
    field = table_.optionalWord(column, kTrialEndings);
  }
  void read(size_t column, std::optional<TimingVerdict>& field) const {
    field = table_.optionalWord(column, kTimingVerdicts);
  }
  void read(size_t column, TrialView& field) const {
    const std::string name = table_.text(column);
    const std::optional<TrialView> view = conditions_.viewNamed(name);
    if (!view) {
      table_.fail(column, fmt::format("is \"{}\", but {}{}", name, conditions_.mustBe(),
                                      conditionsAreKnown_ ? "" : ", unless --protocol FILE names other conditions"));
    }
    field = *view;
  }
  /// Each measure has a column of its own.
  void read(size_t, std::map<std::string, double>&) const {}

 private:
  const CsvTable& table_;
  const ViewConditions& conditions_;
  bool conditionsAreKnown_;
};

class Reading {
 public:
  explicit Reading(const std::string& folder) : folder_(folder) {}

  Dataset all(const std::string& protocolFile) {
    DataSource source;
    source.path = folder_;
    source.form = DataSource::Form::kCsv;
    if (!protocolFile.empty()) {
      source.protocolText = readProtocolText(protocolFile).text;
      const ProtocolFacts facts = protocolFacts(source.protocolText, protocolFile);
      source.protocolName = facts.name;
      data_.conditions = facts.conditions;
      protocolIsKnown_ = true;
      source.protocolSha256 = sha256(source.protocolText);
    }
    readSubjects();
    readSessions(source);
    readTrials();
    readAnswers();
    data_.consentIsKnown = false;
    data_.sources.push_back(std::move(source));
    return std::move(data_);
  }

 private:
  CsvTable open(const char* name) const { return CsvTable(fmt::format("{}/{}", folder_, name)); }
  void readSubjects();
  void readSessions(DataSource& source);
  void readTrials();
  void readAnswers();

  std::string folder_;
  bool protocolIsKnown_ = false;
  Dataset data_{};
  std::map<std::pair<std::string, int>, size_t> sessionIndex_{};
};

void Reading::readSubjects() {
  CsvTable table = open("subjects.csv");
  const size_t id = table.column("subject_id");
  const size_t kind = table.column("subject_kind");
  const size_t simulated = table.column("simulated");
  const size_t slot = table.column("slot");
  const size_t created = table.column("created_utc");
  while (table.next()) {
    Subject subject;
    subject.id = table.name(id);
    subject.kind = table.word(kind, kSubjectKinds);
    subject.simulated = table.flag(simulated);
    subject.slot = table.smallInteger(slot);
    subject.createdUtc = table.text(created);
    if (subject.simulated != isSimulated(subject.kind)) {
      table.fail(simulated, fmt::format("contradicts the kind of subject \"{}\"", nameOf(subject.kind)));
    }
    data_.subjects.push_back(std::move(subject));
  }
  std::sort(data_.subjects.begin(), data_.subjects.end(),
            [](const Subject& a, const Subject& b) { return a.id < b.id; });
}

void Reading::readSessions(DataSource& source) {
  CsvTable table = open("runs.csv");
  const size_t subject = table.column("subject_id");
  const size_t number = table.column("session_number");
  const size_t simulated = table.column("simulated");
  const size_t runNumber = table.column("run_number");
  const size_t ending = table.column("ending");
  const size_t forced = table.column("forced");
  const size_t version = table.column("program_version");
  const size_t environment = table.column("environment_json");
  const size_t timingCheck = table.column("timing_check_json");
  const std::vector<std::string>& names = table.columns();
  const auto station = static_cast<size_t>(std::find(names.begin(), names.end(), "station") - names.begin());
  std::map<std::pair<std::string, int>, int> lastRun;
  while (table.next()) {
    const std::pair key(table.name(subject), table.smallInteger(number));
    const auto [at, isNew] = sessionIndex_.try_emplace(key, data_.sessions.size());
    if (isNew) {
      data_.sessions.emplace_back();
    }
    Session& session = data_.sessions[at->second];
    session.subject = key.first;
    session.number = key.second;
    session.simulated = table.flag(simulated);
    session.forced = session.forced || table.flag(forced);
    ++session.runs;
    int& last = lastRun[key];
    if (table.smallInteger(runNumber) > last) {
      last = table.smallInteger(runNumber);
      session.ending = table.optionalWord(ending, kSessionEndings);
    }
    source.programVersion = table.text(version);
    data_.runs.push_back({0, key.first, key.second, table.smallInteger(runNumber),
                          station < names.size() ? table.text(station) : "", table.flag(forced), table.flag(simulated),
                          table.text(environment), table.text(timingCheck)});
  }
}

void Reading::readTrials() {
  CsvTable table = open("trials.csv");
  const auto column = [&](const char* name) { return table.column(name); };
  std::map<std::string_view, size_t> at;
  std::vector<size_t> measures;
  for (const std::string& name : table.columns()) {
    if (std::find(kTrialColumns.begin(), kTrialColumns.end(), name) == kTrialColumns.end()) {
      measures.push_back(column(name.c_str()));
    }
  }
  for (const std::string_view name : kTrialColumns) {
    if (name != "station") {
      at[name] = column(std::string(name).c_str());
    }
  }
  struct PlanOfSession {
    std::string subject;
    int session;
    int plan;
    auto operator<=>(const PlanOfSession&) const = default;
  };
  std::map<PlanOfSession, int64_t> completed;
  while (table.next()) {
    Trial trial;
    trial.trialId = table.integer(at["trial_id"]);
    trial.subject = table.name(at["subject_id"]);
    trial.session = table.smallInteger(at["session_number"]);
    trial.blockIndex = table.smallInteger(at["block_index"]);
    trial.block = table.name(at["block"]);
    trial.simulated = table.flag(at["simulated"]);
    trial.correct = table.optionalFlag(at["correct"]);
    trial.ending = table.optionalWord(at["ending"], kTrialEndings);
    trial.practice = table.flag(at["practice"]);
    if (!trial.practice && trial.ending == TrialEnding::kCompleted) {
      const int plan = table.smallInteger(at["plan_index"]);
      int64_t& last = completed[{trial.subject, trial.session, plan}];
      const auto session = sessionIndex_.find({trial.subject, trial.session});
      if (session == sessionIndex_.end()) {
        table.fail(at["session_number"], "is of a session that runs.csv does not hold");
      }
      data_.sessions[session->second].completedTrials += last == 0 ? 1 : 0;
      last = trial.trialId;
    }
    if (!table.flag(at["counts"])) {
      data_.otherAttempts.push_back({0, trial.trialId, trial.subject, trial.session, trial.blockIndex, trial.block,
                                     trial.simulated, whyNotCounted(trial.practice, trial.ending), trial.correct,
                                     table.text(at["view"])});
      continue;
    }
    if (trial.practice || trial.ending != TrialEnding::kCompleted) {
      table.fail(at["counts"], "is 1, but the trial is practice or was not completed");
    }
    trial.subjectKind = table.word(at["subject_kind"], kSubjectKinds);
    trial.runId = table.integer(at["run_id"]);
    const TrialFields fields(table, data_.conditions, protocolIsKnown_);
    forEachTrialColumn(trial, [&](std::string_view name, auto& field) {
      if (const auto found = at.find(name); found != at.end()) {
        fields.read(found->second, field);
      }
    });
    for (const size_t measure : measures) {
      if (const auto value = table.optionalReal(measure)) {
        trial.measures[table.columns()[measure]] = *value;
      }
    }
    if (trial.responseSeconds) {
      trial.responseTicks = std::llround(*trial.responseSeconds * kTicksPerSecond);
    }
    if (const auto problem = problemOf(trial)) {
      table.fail(table.column(problem->column), problem->problem);
    }
    trial.digest = digestOf(trial, data_.conditions.nameOf(trial.view));
    data_.trials.push_back(std::move(trial));
  }
}

void Reading::readAnswers() {
  CsvTable table = open("answers.csv");
  const size_t row = table.column("row_id");
  const size_t subject = table.column("subject_id");
  const size_t simulated = table.column("simulated");
  const size_t session = table.column("session_number");
  const size_t form = table.column("form");
  const size_t field = table.column("field");
  const size_t answer = table.column("answer");
  const size_t counts = table.column("counts");
  while (table.next()) {
    if (table.flag(counts)) {
      data_.answers.push_back({0, table.integer(row), table.name(subject), table.smallInteger(session),
                               table.name(form), table.name(field), table.text(answer), table.flag(simulated)});
    }
  }
}

}  // namespace

Dataset readCsvExport(const std::string& folder, const std::string& protocolFile) {
  return Reading(folder).all(protocolFile);
}

}  // namespace ocelli
