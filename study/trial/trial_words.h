// The words that a study writes and its analysis reads: who a subject is, how trials, runs and sessions ended, and what
// the timing of a trial's frames was. The database has them as these texts (protocols/trials.schema.sql).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ocelli {

/// Who gives the answers. Every row that is stored says so.
enum class SubjectKind : uint8_t {
  kPerson,
  kGenerator,  ///< simulated: numbers with known effects, which sees nothing
  kObserver,   ///< simulated: sees identity images of the frames
};
inline constexpr std::array kSubjectKinds{SubjectKind::kPerson, SubjectKind::kGenerator, SubjectKind::kObserver};
/// "person", "simulated_generator", "simulated_observer".
const char* nameOf(SubjectKind kind);
inline bool isSimulated(SubjectKind kind) {
  return kind != SubjectKind::kPerson;
}

/// `kRedone` and `kAborted` are by the experimenter, or as the subject was unwell.
enum class TrialEnding : uint8_t { kCompleted, kRedone, kAborted };
inline constexpr std::array kTrialEndings{TrialEnding::kCompleted, TrialEnding::kRedone, TrialEnding::kAborted};
/// "completed", "redone", "aborted".
const char* nameOf(TrialEnding ending);

/// Of a run, and so of its session.
enum class SessionEnding : uint8_t { kCompleted, kUnwell, kAborted, kDeclined, kFailed };
inline constexpr std::array kSessionEndings{SessionEnding::kCompleted, SessionEnding::kUnwell, SessionEnding::kAborted,
                                            SessionEnding::kDeclined, SessionEnding::kFailed};
/// "completed", "unwell", "aborted", "declined", "failed".
const char* nameOf(SessionEnding ending);

enum class TimingVerdict : uint8_t {
  kGood,
  kDroppedFrames,    ///< too many of them
  kEarlyFrames,      ///< they did not wait for the screen
  kUnstableRefresh,  ///< the run was forced although the check at its start refused
  kSimulatedClock,
};
inline constexpr std::array kTimingVerdicts{TimingVerdict::kGood, TimingVerdict::kDroppedFrames,
                                            TimingVerdict::kEarlyFrames, TimingVerdict::kUnstableRefresh,
                                            TimingVerdict::kSimulatedClock};
/// "good", "dropped_frames", "early_frames", "unstable_refresh", "simulated_clock".
const char* nameOf(TimingVerdict verdict);

/// What ends an exposure: the time for which the scene has been on the screen, or the number of frames that showed it,
/// as in databases before version 3.
enum class ExposureRule : uint8_t { kClock, kFrames };
inline constexpr std::array kExposureRules{ExposureRule::kClock, ExposureRule::kFrames};
/// "clock", "frames".
const char* nameOf(ExposureRule rule);

/// The word of `words` that has the name; nothing where none has it.
template <class Word, size_t kCount>
std::optional<Word> wordNamed(std::string_view name, const std::array<Word, kCount>& words) {
  for (const Word word : words) {
    if (nameOf(word) == name) {
      return word;
    }
  }
  return std::nullopt;
}

/// "completed, redone, aborted".
template <class Word, size_t kCount>
std::string namesOf(const std::array<Word, kCount>& words) {
  std::string names;
  for (const Word word : words) {
    names.append(names.empty() ? "" : ", ").append(nameOf(word));
  }
  return names;
}

}  // namespace ocelli
