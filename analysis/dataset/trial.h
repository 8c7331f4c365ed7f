// One trial that counts, as an analysis knows it: a row of `final_trial` (protocols/trials.schema.sql), and where it
// came from.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "oc_core/base/sha256.h"
#include "study/trial/view_condition.h"

namespace ocelli {

struct Trial {
  // Where the row is.
  int source = 0;       ///< file of the dataset, from 0
  int64_t trialId = 0;  ///< in that file
  Digest digest{};      ///< of the row, with the columns that no analysis reads (row_digest.h)

  // The plan.
  std::string subject;
  int session = 1;
  int planIndex = 0;  ///< in the schedule of the session
  int blockIndex = 0;
  std::string block;
  std::string task;  ///< "find", "count", "path", ...
  int caseIndex = 0;
  std::string caseLabel;
  TrialView view = TrialView::kReference;
  int attempt = 1;
  bool simulated = false;
  std::string subjectKind;  ///< "person", "simulated_observer", ...

  // The case, where it has these.
  std::optional<bool> moving{};
  std::optional<double> exposureSeconds{};
  std::optional<int> objects{};
  std::optional<bool> duplicateColors{};
  std::optional<double> longestSeconds{};

  // What was done.
  std::string answer;
  std::string expected;
  std::optional<bool> correct{};
  std::optional<bool> censored{};  ///< time ran out: the response would have come after responseSeconds
  std::optional<double> responseSeconds{};
  std::map<std::string, double> measures{};

  // Timing.
  int64_t frames = 0;
  int64_t droppedFrames = 0;
  std::string timingVerdict;
  std::optional<int64_t> screenWidth{};  ///< pixels
  std::optional<int64_t> screenHeight{};
  std::optional<double> refreshHertz{};  ///< of the screen

  /// What is the same item for all subjects: the case of a block in a session.
  std::string item() const { return block + "/" + std::to_string(session) + "/" + std::to_string(caseIndex); }
};

}  // namespace ocelli
