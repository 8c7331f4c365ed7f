// What a session leaves behind, as it is stored. Times in nanoseconds are of a clock that never jumps, since the run of
// the program began; times in UTC are ISO 8601 with milliseconds, for people.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/input_event.h"
#include "study/task/task.h"
#include "study/trial/trial_words.h"

namespace ocelli {

/// One start of the program for a session: the first, or one that resumes it.
struct RunRecord {
  std::string subject;  ///< pseudonymous id
  SubjectKind kind = SubjectKind::kPerson;
  int slot = 0;
  int session = 1;  ///< from 1
  std::string startedUtc;
  std::string programVersion;
  std::string station;      ///< name of this computer
  std::string environment;  ///< JSON: system, graphics, screen, monitor, clocks, how input is time-stamped, what is not
                            ///< measured
  std::string timingCheck;  ///< JSON: what the start-up check measured, and its verdict
  bool forced = false;      ///< started although the check refused
  std::string simulation{};  ///< JSON: parameters of a simulated subject
};

struct FrameRecord {
  int64_t frame = 0;  ///< of the trial, from 0
  int64_t tick = 0;   ///< that the image shows
  int64_t shownNanoseconds = 0;
  WalkerPose pose;
  std::optional<uint64_t> pixelHash{};

  bool operator==(const FrameRecord&) const = default;
};

struct InputRecord {
  int64_t nanoseconds = 0;  ///< when it came
  int64_t tick = 0;         ///< at which the trial took it
  InputEvent event;
};

/// Where the subject looked, as an eye tracker says, while a trial ran.
struct GazeRecord {
  int64_t nanoseconds = 0;        ///< when the sample came, as InputRecord::nanoseconds
  double deviceTime = 0;          ///< by the tracker's clock, in its unit
  bool valid = true;              ///< as the tracker says
  double x = 0;                   ///< pixels of the trial's screen, from its left edge; may lie outside of it
  double y = 0;                   ///< from its upper edge
  std::optional<double> pupil{};  ///< in the tracker's unit

  bool operator==(const GazeRecord&) const = default;
};

/// Verdict on the timing of a trial's frames.
struct TrialTiming {
  int64_t frames = 0;
  int64_t dropped = 0;  ///< intervals of more than TimingLimits::lateFactor
  int64_t medianNanoseconds = 0;
  int64_t longestNanoseconds = 0;
  /// kEarlyFrames: the median is less than the screen's interval divided by TimingLimits::lateFactor.
  TimingVerdict verdict = TimingVerdict::kGood;
};

struct TrialRecord {
  TrialPlan plan;
  int attempt = 1;  ///< of the same plan; the last completed one counts
  CaseInfo info;
  TrialScreen screen;
  int64_t startedNanoseconds = 0;
  int64_t endedNanoseconds = 0;
  std::string startedUtc;
  std::string endedUtc;
  TrialEnding ending = TrialEnding::kCompleted;
  TrialOutcome outcome;  ///< empty where it was not completed
  TrialTiming timing;
};

struct AnswerRecord {
  std::string form;
  std::string field;
  std::string answer;
  std::string utc;
};

struct ConsentRecord {
  std::string title;
  std::string text;  ///< as it was shown
  std::string sha256;
  bool agreed = false;
  std::string utc;
};

/// Anything else that happened: "pause", "resume", "note", "redo", "abort", "break", "page", "unwell", "clock_jump",
/// "late_frames", "early_frames", "monitor_lost", "screen_changed", ... A staircase that has done its trials leaves
/// "staircase", with block, condition and threshold. Practice of a block leaves "practice_passed",
/// or "practice_failed" and then, where the session goes on nevertheless, "practice_continued"; their detail is the
/// index of the block in the protocol. Where each view is practised by itself, all but the last leave
/// "practice_view_passed" and "practice_view_continued" instead.
struct EventRecord {
  int64_t nanoseconds = 0;
  std::string utc;
  std::string what;
  std::string detail{};
};

}  // namespace ocelli
