// Who does what in which order: the trials of each session of each subject, counterbalanced over subjects.
//
// A subject has a slot: subject 0, 1, 2, ... of the study. Slots decide what is counterbalanced: the view that comes
// first, the order of blocks, and which view shows a case first, or alone. What follows is of a study of two conditions
// (counterbalance.h): over the slots 0 to n - 1, for any n, the counts of the levels of each of these, and of their
// combinations, differ by at most one. Other numbers of conditions follow Williams designs (condition_order.h).
//
// Balanced blocks. The cases come in one pass, or in two where each is seen in both views. In a pass views take turns,
// beginning with the first view of the session; even and odd cases have different views (the last one of an odd number
// has the first view); in which order the cases of a view come is shuffled for each subject and session. In the second
// pass each case has its other view.
//
// Alternating blocks are the same for everyone: pinhole first, views in turn, passes in the order of the file. Where
// the number of cases is even the second pass begins with the second case and ends with the first: views go on taking
// turns, and each case gets its other view.
//
// Blocks with a staircase (block_staircase.h) come in rounds of all conditions. Their plans say which condition comes
// when; their case stands for one that is known when the trial begins: shownPlan() of staircase_trials.h.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/protocol/protocol.h"

namespace ocelli {

struct SessionSchedule {
  int slot = 0;
  int session = 1;  ///< from 1
  TrialView firstView = TrialView::kReference;
  std::vector<int> blockOrder;    ///< indices of the protocol's blocks
  std::vector<TrialPlan> trials;  ///< in order, without practice
  uint64_t seed = 1;

  bool operator==(const SessionSchedule&) const = default;
};

/// In which sessions a block is.
bool isInSession(const ProtocolBlock& block, int session);

/// The orders of the blocks of a session over which the slots are counterbalanced: one where blocks are not shuffled.
std::vector<std::vector<int>> blockOrdersOf(const Protocol& protocol, int session);

/// The same for the same protocol, slot, session and seed. Throws InputError where the protocol has no such session.
SessionSchedule scheduleOf(const Protocol& protocol, int slot, int session, uint64_t seed);

/// The rounds of the practice of a block: one a view, the first view first, where each is practised by itself; else a
/// single one of no view in particular. None where the block has no practice.
std::vector<std::optional<TrialView>> practiceRounds(const SessionSchedule& schedule, const Protocol& protocol,
                                                     int block);

/// The practice trial number `number` (from 0) of a round of a block: cases in turn; views in turn where the round is
/// of no view in particular.
TrialPlan practiceTrial(const SessionSchedule& schedule, const Protocol& protocol, int block, int number,
                        std::optional<TrialView> round = {});

/// As JSON text, for the database.
std::string jsonText(const SessionSchedule& schedule, const ViewConditions& conditions);

}  // namespace ocelli
