// What each subject's slot decides: the first view, the order of blocks, and which view shows a case first or alone.
//
// Over the slots 0 to n - 1, for any n, the counts of the levels of each of these differ by at most one, and so do
// those of each pair of them and of all three together. That holds where the levels are all different in each aligned
// run of as many slots as there are levels (pairs of levels, triples of levels), which is how the slots are laid out.
//
// With two orders that is impossible: slots 0 and 1 must then differ in all three, and so must slots 2 and 3, but the
// three differences between slots 0 and 2 (first view, order, assignment) that make all three pairs complete after four
// slots have an even sum, while three times one is odd. There, (first view, assignment) is complete after each eight
// slots only, and its counts differ by at most two before.
#pragma once

#include <vector>

namespace ocelli {

struct SlotLevels {
  int firstView = 0;   ///< 0 or 1
  int order = 0;       ///< of `orders`
  int assignment = 0;  ///< 0 or 1: whether even or odd cases have the first of two views

  bool operator==(const SlotLevels&) const = default;
};

/// `orders` is 1, 2, an odd number, or a multiple of 4. In every other session first view and assignment are swapped.
/// `sessionsBefore`: how many the subject has had.
SlotLevels levelsOf(int slot, int sessionsBefore, int orders);

/// Orders in which so many blocks come, by number: each block is equally often in each place, and, where `blocks` is
/// even, equally often before each other. As many as there are blocks; twice as many, the second half backwards, where
/// levelsOf() takes no such number.
std::vector<std::vector<int>> blockOrders(int blocks);

}  // namespace ocelli
