// Markers: what a session tells other devices of, such as amplifiers, eye trackers and recorders, at the moment of the
// frame that shows it. docs/markers.md has the table of codes.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace ocelli {

struct MarkerCode {
  uint8_t code = 0;  ///< a byte that is not 0; it stays for ever
  const char* name = "";
  const char* meaning = "";
};

inline constexpr MarkerCode kSessionStarts{1, "session_start", "the first frame of the session"};
inline constexpr MarkerCode kSessionEnds{2, "session_end", "the session has ended, in whichever way"};
inline constexpr MarkerCode kTrialInReference{10, "trial_start_reference",
                                              "the first frame of a trial in the condition that is the reference"};
inline constexpr MarkerCode kTrialInOther{11, "trial_start_other", "the first frame of a trial in the other condition"};
inline constexpr MarkerCode kPracticeInReference{12, "practice_start_reference", "the same of practice"};
inline constexpr MarkerCode kPracticeInOther{13, "practice_start_other", "the same of practice"};
inline constexpr MarkerCode kAnsweredRight{20, "answer_right", "the answer was right, or what was sought was found"};
inline constexpr MarkerCode kAnsweredWrong{21, "answer_wrong", "the answer was not right"};
inline constexpr MarkerCode kTimeOver{22, "time_over", "the time ran out before an answer"};
inline constexpr MarkerCode kTrialEnds{30, "trial_end", "the first frame after a trial, which follows its answer"};
inline constexpr MarkerCode kTrialBrokenOff{31, "trial_broken_off", "the same where the trial was not completed"};

inline constexpr std::array kMarkerCodes{
    kSessionStarts, kSessionEnds,   kTrialInReference, kTrialInOther, kPracticeInReference, kPracticeInOther,
    kAnsweredRight, kAnsweredWrong, kTimeOver,         kTrialEnds,    kTrialBrokenOff};

struct Marker {
  int64_t sequence = 0;     ///< of the run, from 0: a receiver sees what it has lost
  int64_t nanoseconds = 0;  ///< when the frame was shown, since the run began: the clock of the database
  MarkerCode code;
  int trial = -1;           ///< trial_number of the database, from 0; -1 where it is of no trial
  std::string condition{};  ///< its name in the protocol
  std::string answer{};
};

/// The columns of lineOf(), separated by commas.
inline constexpr const char* kMarkerColumns = "sequence,nanoseconds,code,name,trial_number,condition,answer";
/// "7,1234567890,20,answer_right,3,gc,left"; what is empty or of no trial is left empty. RFC 4180, without its end.
std::string lineOf(const Marker& marker);

}  // namespace ocelli
