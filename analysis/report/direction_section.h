// Circular statistics of estimated directions by condition: mean vectors of subjects, tests of whether they agree and
// how conditions differ, and estimates that are mirrored.
#pragma once

#include <string>

#include "analysis/report/estimate_trials.h"

namespace ocelli {

struct ReportWork;

/// `id` starts the names of its tables.
void addDirectionSection(ReportWork& work, const std::string& id, const EstimateTrials& estimates);

/// How an estimate lies to the truth where 0 degrees is straight ahead. Reversals are told of truths that lie more than
/// kMirrorMargin from the axis that they would be mirrored at: nearer to it, any small error crosses it.
struct MirroredEstimate {
  bool isFront = false;               ///< within 90 degrees of straight ahead
  std::optional<bool> isFrontBack{};  ///< it lies in the other half, front or back, than the truth
  std::optional<bool> isLeftRight{};
  bool isBeyondQuarter = false;  ///< off by more than 90 degrees
};
inline constexpr double kMirrorMargin = 15;  ///< degrees
MirroredEstimate mirroredEstimate(const EstimatedValue& value);

}  // namespace ocelli
