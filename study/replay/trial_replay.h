// A trial again, from its log: what was done at which tick goes into a new run of the same trial, which must then be
// where it was in each frame, bit by bit, and come to the same outcome.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/session/records.h"
#include "study/task/trial_image.h"

namespace ocelli {

/// What is stored of a trial.
struct TrialLog {
  TrialRecord record;
  std::vector<FrameRecord> frames;  ///< in order
  std::vector<InputRecord> inputs;  ///< likewise
  std::vector<GazeRecord> gaze{};   ///< likewise; a replay does nothing with it but show it
};

struct ReplayVerdict {
  int64_t frames = 0;
  int64_t samePoses = 0;
  int64_t hashes = 0;      ///< frames whose hash is known and was compared
  int64_t sameHashes = 0;  ///< of these
  bool sameOutcome = false;
  std::string firstDifference{};  ///< in words; empty where there is none

  bool isSame() const { return samePoses == frames && sameHashes == hashes && sameOutcome; }
};

struct ReplayOptions {
  /// Compares the hashes of frames where they are known, with images by this renderer: it must be the one that drew
  /// them. None are compared where it is empty.
  ViewPainter views{};
  /// Called for each frame when it is shown.
  std::function<void(const FrameRecord& frame, const TrialRun& run)> onFrame{};
};

/// `block` is that of the trial's plan, with the practice cases for practice.
ReplayVerdict replayTrial(const TaskBlock& block, const TrialLog& log, const ReplayOptions& options = {});

}  // namespace ocelli
