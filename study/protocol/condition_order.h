// The order of conditions in a study that has another number of them than two (a pair is laid out by counterbalance.h).
//
// Within a block conditions come in runs. In a run each condition stands once, in the order of a row of a Williams
// design (Williams 1949, Experimental designs balanced for the estimation of residual effects of treatments, Aust. J.
// Sci. Res. A 2): a Latin square in which each condition follows each other one equally often. Of an even number k of
// conditions it has k rows; of an odd number 2k, those of the square and the same backwards. A subject's first run is a
// row; each later run is the row of the same kind that begins with the condition d after the one that was last, and d
// goes through 1 to k - 1, so that neighbours across the ends of runs are balanced as well. Where the number of cases
// is no multiple of k the last run of a pass holds only the conditions of the cases that are left.
//
// The cases come in one pass, or in k where each case is seen in all conditions: in pass p case i has the condition
// i + p + assignment (mod k). In which order the cases of a condition come is shuffled for each subject and session.
//
// Slot s decides: first condition s, kind of row s / k (mod 2, of an odd k), assignment s + s / k (mod k), order of
// blocks. In each aligned run of k slots every condition is once at every place of a block, and every case is once in
// every condition of a pass; after k (of an odd number 2k) slots, neighbours within runs are balanced. First condition
// and assignment are complete together after k * k slots, first condition and order of blocks after their product.
#pragma once

#include <vector>

#include "oc_core/base/random.h"
#include "study/trial/view_condition.h"

namespace ocelli {

/// The rows of the Williams design: conditions from 0 to `conditions` - 1.
std::vector<std::vector<int>> williamsRows(int conditions);

struct ConditionLevels {
  int first = 0;          ///< condition of the first trial
  bool backward = false;  ///< the kind of row: always false of an even number
  int assignment = 0;     ///< 0 to `conditions` - 1
  int order = 0;          ///< of `orders` of blocks

  bool operator==(const ConditionLevels&) const = default;
};

/// From session to session first condition and assignment move on by one.
ConditionLevels conditionLevelsOf(int slot, int sessionsBefore, int conditions, int orders);

struct CaseInCondition {
  int caseIndex = 0;
  TrialView view = TrialView::kReference;
};

/// The trials of a balanced block. `all`: each case in all conditions, or else in one.
std::vector<CaseInCondition> trialsInRuns(int cases, int conditions, bool all, const ConditionLevels& levels,
                                          Random& random);

/// Of an alternating block, the same for everyone: cases in the order of the file, conditions in turn; in each further
/// pass every case has the next condition.
std::vector<CaseInCondition> trialsInTurn(int cases, int conditions, bool all);

}  // namespace ocelli
