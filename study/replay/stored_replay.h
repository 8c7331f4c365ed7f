// Trials of a database again: with the protocol that the database holds, whatever has become of its file.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "study/replay/trial_replay.h"
#include "study/store/study_database.h"

namespace ocelli {

struct TrialChoice {
  std::string subject{};         ///< empty for all
  std::optional<int> session{};  ///< from 1; missing for all
  std::optional<int> trial{};    ///< of the schedule, from 0; missing for all
  bool withPractice = false;
};

/// How many trials were compared, and what came of it.
struct ReplaySummary {
  int64_t trials = 0;
  int64_t posesSame = 0;     ///< trials of which all were
  int64_t outcomesSame = 0;  ///< trials
  int64_t frames = 0;
  int64_t framesSame = 0;
  int64_t hashes = 0;  ///< frames
  int64_t hashesSame = 0;
  int64_t withoutLog = 0;                  ///< trials of generators, and those that were killed before their end
  std::vector<std::string> differences{};  ///< of trials that are not the same, the first ones, in words

  bool allSame() const { return posesSame == trials && outcomesSame == trials && hashesSame == hashes; }
};

class ReplayStudy {
 public:
  /// Throws InputError where there is no such database, or its protocol cannot be read by this program.
  explicit ReplayStudy(const std::filesystem::path& database);

  const Protocol& protocol() const { return protocol_; }
  const StudyDatabase& database() const { return database_; }
  /// In the order in which they began. Throws InputError where there is none.
  std::vector<TrialRow> trials(const TrialChoice& choice) const;
  TrialLog logOf(const TrialRow& trial) const;
  /// Of the trial's plan, with the practice cases for practice.
  const TaskBlock& blockOf(const TrialRow& trial) const;
  /// "sim-0001, session 2, trial 14 (find stationary, gc, location 3)".
  std::string nameOf(const TrialRow& trial) const;
  /// What drew it: of simulated subjects as `study simulate --renderer` has it, of people what OpenGL calls itself.
  std::string rendererOf(const TrialRow& trial) const;

  /// All of these, on all threads. Hashes are compared of trials by a renderer in `painters`, which are called by many
  /// threads at once.
  ReplaySummary check(const std::vector<TrialRow>& trials, const std::map<std::string, ViewPainter>& painters,
                      const Progress& progress = {}) const;

 private:
  StudyDatabase database_;
  Protocol protocol_;
};

}  // namespace ocelli
