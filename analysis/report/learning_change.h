// What changes from session to session and within the blocks of a session, one number a subject.
#pragma once

#include "analysis/report/subject_means.h"

namespace ocelli {

enum class BlockHalf : uint8_t { kFirst, kSecond };

/// Where trials stand in their blocks: of each view in each block of each session of each subject, in the order of the
/// plan. The middle one of an odd number is in neither half. Left out are blocks that have fewer trials of a view than
/// others had, as their order says less; and items that all subjects had in the same half, as where all have the same
/// order, because then halves differ in their items.
class BlockHalves {
 public:
  explicit BlockHalves(const TrialList& trials);

  bool isEmpty() const { return halves_.empty(); }
  TrialValues valuesOf(const TrialValues& values, BlockHalf half) const;

 private:
  std::map<const Trial*, BlockHalf> halves_;
};
/// Why there are none.
inline constexpr const char* kNoHalves =
    "no case came in the first half of its block for some subjects and in the second for others, so that halves would "
    "differ in their cases";

TrialValues valuesOfSession(const TrialValues& values, int session);

/// Slope of the line of least squares through a subject's means of sessions, of subjects with two sessions or more.
SubjectNumbers sessionSlopes(const TrialValues& values);

/// Mean of the second half less that of the first.
SubjectNumbers halfDifferences(const TrialValues& values, const BlockHalves& halves);

}  // namespace ocelli
