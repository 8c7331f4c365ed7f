// How evenly the cells of the design are filled, counted from the schedules of the first subjects of a study.
#pragma once

#include <string>
#include <vector>

#include "study/protocol/schedule.h"

namespace ocelli {

struct BalanceCell {
  std::string levels;  ///< "ppc first, order 2"
  int subjects = 0;    ///< or trials of all of them, where `ofTrials` says so
};

struct BalanceTable {
  std::string factors;             ///< "first view x block order"
  std::vector<BalanceCell> cells;  ///< all that can be, those with no subject too
  int difference = 0;              ///< between the fullest and the emptiest cell that are to be alike
  bool ofTrials = false;
};

/// Of the session, over subjects 0 to `subjects` - 1: the first view, the order of blocks, the places of blocks, and of
/// each case in which view it is seen, first or only; and the combinations of these. With another number of conditions
/// than two also which condition stands at which place of a block, and which follows which from trial to trial. Blocks
/// in the same order for everyone are not counterbalanced, and have no tables.
std::vector<BalanceTable> balanceOf(const Protocol& protocol, int subjects, int session, uint64_t seed);

}  // namespace ocelli
