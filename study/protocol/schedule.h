// Who does what in which order: the trials of each session of each subject, counterbalanced over subjects.
//
// A subject has a slot: subject 0, 1, 2, ... of the study. Slots decide what is counterbalanced: the view that comes
// first, the order of blocks, and which view shows a case that is seen in one view only. Over the slots 0 to n - 1, for
// any n, the counts of the levels of each of these, and of their combinations, differ by at most one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/protocol/protocol.h"

namespace ocelli {

struct SessionSchedule {
  int slot = 0;
  int session = 0;  ///< from 0
  StudyView firstView = StudyView::kPinhole;
  std::vector<int> blockOrder;    ///< indices of the protocol's blocks
  std::vector<TrialPlan> trials;  ///< in order, without practice
  uint64_t seed = 1;
};

/// The same for the same protocol, slot, session and seed. Throws InputError where the protocol has no such session.
SessionSchedule scheduleOf(const Protocol& protocol, int slot, int session, uint64_t seed);

/// The practice trial number `number` (from 0) of a block: cases and views in turn.
TrialPlan practiceTrial(const SessionSchedule& schedule, const Protocol& protocol, int block, int number);

/// As JSON text, for the database.
std::string jsonText(const SessionSchedule& schedule);

}  // namespace ocelli
