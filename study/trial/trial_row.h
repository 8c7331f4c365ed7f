// One attempt at a trial: a row of the table `trial` (protocols/trials.schema.sql), as the study writes it and an
// analysis reads it. Sessions and runs count from 1 everywhere, as their columns are `_number`s; what is an `_index`
// counts from 0.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "study/trial/trial_words.h"
#include "study/trial/view_condition.h"

namespace ocelli {

inline constexpr int kNoPlan = -1;

/// What is not known, or does not apply, is NULL in the file and missing or empty here.
struct TrialRow {
  int64_t trialId = 0;  ///< in its file; later attempts have larger ones
  int64_t runId = 0;

  // The plan.
  std::string subject;  ///< pseudonymous id
  SubjectKind subjectKind = SubjectKind::kPerson;
  bool simulated = false;
  int session = 1;
  int trialNumber = 0;  ///< among those that the run began, practice included
  bool practice = false;
  int planIndex = 0;  ///< in the schedule of the session; kNoPlan in practice, which is not in it
  int attempt = 1;    ///< at the same plan; the last completed one counts
  int blockIndex = 0;
  std::string block;
  std::string task;   ///< "find", "count", "path", ...
  int caseIndex = 0;  ///< in the block's cases, or its practice cases
  TrialView view = TrialView::kReference;
  std::optional<uint64_t> trialSeed{};  ///< of what is random in it

  // How it ended. The columns from here on are known of what did.
  std::optional<TrialEnding> ending{};
  std::optional<int64_t> startedNs{};  ///< of the run's clock, which never jumps
  std::optional<int64_t> endedNs{};
  std::string startedUtc{};  ///< ISO 8601 with milliseconds
  std::string endedUtc{};

  // The case, where it has these.
  std::string caseLabel{};
  std::optional<bool> moving{};
  std::optional<double> exposureSeconds{};     ///< planned; missing where the subject ends it
  std::optional<ExposureRule> exposureRule{};  ///< missing in files before version 3: frames were counted
  std::optional<int> objects{};                ///< how many there are, where that is the question
  std::optional<bool> duplicateColors{};
  std::optional<double> longestSeconds{};  ///< until the trial ends by itself, answering included
  std::optional<double> typicalSeconds{};

  // What was done, in trials that were completed.
  std::string answer{};
  std::string expected{};
  std::optional<bool> correct{};
  std::optional<bool> censored{};           ///< time ran out: the response would have come after responseSeconds
  std::optional<double> responseSeconds{};  ///< in steps of 1/240 s; with an exposure from its end
  std::optional<int64_t> responseTicks{};   ///< the same in these steps
  std::optional<int64_t> exposureFrames{};
  std::optional<double> exposureShownSeconds{};  ///< from the first frame with the scene to the first without it
  std::map<std::string, double> measures{};      ///< what else the task tells

  // The timing of its frames.
  int64_t frames = 0;
  int64_t droppedFrames = 0;
  std::optional<int64_t> medianIntervalNs{};
  std::optional<int64_t> longestIntervalNs{};
  std::optional<TimingVerdict> timingVerdict{};
  std::optional<int64_t> screenWidth{};   ///< pixels
  std::optional<int64_t> screenHeight{};  ///< pixels
  std::optional<double> refreshHertz{};   ///< of the screen

  bool operator==(const TrialRow&) const = default;

  /// What is the same item for all subjects: the case of a block in a session.
  std::string item() const { return block + "/" + std::to_string(session) + "/" + std::to_string(caseIndex); }
};

// The columns, each with the field that holds it, in the order of the table. Reading a database, storing a trial and
// reading tables go through these, so that each column is named once. `visit(name, field)` is called with the fields of
// `row`, which may be const; a field's type says which values its column has.

/// The version of the tables (trials_file.h) that brought a column.
constexpr int firstVersionOf(std::string_view column) {
  return column == "exposure_rule" || column == "exposure_shown_s" ? 3 : 1;
}

/// Known when a trial begins. Which subject, session and run it belongs to has its columns in all tables.
template <class Row, class Visit>
void forEachPlanColumn(Row& row, const Visit& visit) {
  visit("trial_number", row.trialNumber);
  visit("practice", row.practice);
  visit("plan_index", row.planIndex);
  visit("attempt", row.attempt);
  visit("block_index", row.blockIndex);
  visit("block", row.block);
  visit("task", row.task);
  visit("case_index", row.caseIndex);
  visit("view", row.view);
  visit("trial_seed", row.trialSeed);
}

/// Known when a trial has ended: how, and its case.
template <class Row, class Visit>
void forEachCaseColumn(Row& row, const Visit& visit) {
  visit("ending", row.ending);
  visit("started_ns", row.startedNs);
  visit("ended_ns", row.endedNs);
  visit("started_utc", row.startedUtc);
  visit("ended_utc", row.endedUtc);
  visit("case_label", row.caseLabel);
  visit("moving", row.moving);
  visit("exposure_s", row.exposureSeconds);
  visit("exposure_rule", row.exposureRule);
  visit("objects", row.objects);
  visit("duplicate_colors", row.duplicateColors);
  visit("longest_s", row.longestSeconds);
  visit("typical_s", row.typicalSeconds);
}

/// Known where a trial was completed.
template <class Row, class Visit>
void forEachOutcomeColumn(Row& row, const Visit& visit) {
  visit("answer", row.answer);
  visit("expected", row.expected);
  visit("correct", row.correct);
  visit("censored", row.censored);
  visit("response_s", row.responseSeconds);
  visit("response_ticks", row.responseTicks);
  visit("exposure_frames", row.exposureFrames);
  visit("exposure_shown_s", row.exposureShownSeconds);
  visit("measures_json", row.measures);
}

/// Known when a trial has ended: what its frames were like.
template <class Row, class Visit>
void forEachTimingColumn(Row& row, const Visit& visit) {
  visit("frames", row.frames);
  visit("dropped_frames", row.droppedFrames);
  visit("median_interval_ns", row.medianIntervalNs);
  visit("longest_interval_ns", row.longestIntervalNs);
  visit("timing_verdict", row.timingVerdict);
  visit("screen_width_px", row.screenWidth);
  visit("screen_height_px", row.screenHeight);
  visit("refresh_hz", row.refreshHertz);
}

template <class Row, class Visit>
void forEachTrialColumn(Row& row, const Visit& visit) {
  forEachPlanColumn(row, visit);
  forEachCaseColumn(row, visit);
  forEachOutcomeColumn(row, visit);
  forEachTimingColumn(row, visit);
}

}  // namespace ocelli
