// The trials of blocks with staircases: their order, and which case each shows once it is its turn. A trial shows the
// case that follows from the trials of its block and condition which come before it in the schedule, as they were
// completed: the same whenever it is asked, so that sessions can be resumed and trials done again.
#pragma once

#include <map>
#include <optional>

#include "oc_core/base/random.h"
#include "study/protocol/condition_order.h"
#include "study/protocol/protocol.h"

namespace ocelli {

/// What a completed trial of the schedule leaves for the trials after it.
struct AnsweredCase {
  int block = 0;
  TrialView view = TrialView::kReference;
  int caseIndex = 0;
  bool correct = false;
};
/// By index of the plan.
using AnsweredCases = std::map<int, AnsweredCase>;

/// Rounds of all conditions, each round in an order of its own; the first begins with `first`. In blocks that alternate
/// all rounds have the order of the conditions. The cases are BlockStaircase::middleCase().
std::vector<CaseInCondition> staircaseTrials(const ProtocolBlock& block, size_t conditions, TrialView first,
                                             Random& random);

/// The plan with the case that it shows; plans of other blocks and of practice as they are.
TrialPlan shownPlan(const Protocol& protocol, const TrialPlan& plan, const AnsweredCases& answered);

/// What the staircase of a block and a condition tells so far.
struct StaircaseState {
  int trials = 0;
  std::optional<double> threshold{};
};
StaircaseState staircaseState(const Protocol& protocol, int block, TrialView view, const AnsweredCases& answered);

/// "0.12", or "no threshold yet".
std::string thresholdText(const StaircaseState& state);

}  // namespace ocelli
