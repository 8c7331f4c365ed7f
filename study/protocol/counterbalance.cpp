#include "study/protocol/counterbalance.h"

#include <algorithm>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// A multiple of 4: each run of `orders` slots has the orders one after the other. `unlike` is first view xor
/// assignment.
SlotLevels withMultipleOfFour(int place, int orders) {
  const int run = place / orders;
  const int order = place % orders;
  const int firstView = (order + run) % 2;
  const int unlike = (order / 2 + run / 2) % 2;
  return {firstView, order, firstView ^ unlike};
}

/// An odd number. Slots 2i and 2i + 1 are pair i: both first views with one `unlike`, which alternates from pair to
/// pair. Of two runs of `orders` slots the second has the orders of the first, each with the other first view and the
/// same `unlike`; the pair in the middle, which is in both, has one order.
SlotLevels withOdd(int place, int orders) {
  const int middle = (orders - 1) / 2;
  const int within = place % (2 * orders);
  const int firstView = within % 2;
  const int unlike = place / 2 % 2;
  int order = within;
  if (within == 2 * middle + 1) {
    order = 2 * middle;
  } else if (within > orders) {
    // The pair of the first run that this one repeats: the one before by an even number, for the same `unlike`.
    const int pair = within / 2;
    const int before = middle % 2 == 1 ? pair - middle - 1 : pair == 2 * middle ? 0 : pair - middle;
    order = 2 * before + 1 - firstView;
  }
  return {firstView, order, firstView ^ unlike};
}

SlotLevels withTwo(int place) {
  const int firstView = place % 2;
  return {firstView, (place + place / 2) % 2, firstView ^ (place / 4 % 2)};
}

}  // namespace

SlotLevels levelsOf(int slot, int sessionsBefore, int orders) {
  OC_CHECK(slot >= 0 && sessionsBefore >= 0, "slots count from 0");
  OC_CHECK(orders == 2 || orders % 2 == 1 || orders % 4 == 0, "no layout of slots for so many orders");
  const int period = orders == 2 ? 8 : 4 * orders;
  const int place = slot % period;
  SlotLevels levels = orders == 2       ? withTwo(place)
                      : orders % 2 == 1 ? withOdd(place, orders)
                                        : withMultipleOfFour(place, orders);
  levels.firstView ^= sessionsBefore % 2;
  levels.assignment ^= sessionsBefore % 2;
  return levels;
}

std::vector<std::vector<int>> blockOrders(int blocks) {
  // Rows of Williams' Latin square: 0, 1, n - 1, 2, n - 2, ..., shifted by one from row to row.
  std::vector<std::vector<int>> orders;
  for (int row = 0; row < blocks; ++row) {
    std::vector<int> order;
    for (int i = 0; i < blocks; ++i) {
      const int step = i % 2 == 1 ? (i + 1) / 2 : blocks - i / 2;
      order.push_back((row + step) % blocks);
    }
    orders.push_back(order);
  }
  if (blocks % 4 == 2 && blocks > 2) {
    for (int row = 0; row < blocks; ++row) {
      std::vector<int> mirrored = orders[static_cast<size_t>(row)];
      for (int& block : mirrored) {
        block = (blocks - block) % blocks;
      }
      orders.push_back(mirrored);
    }
  }
  return orders;
}

}  // namespace ocelli
