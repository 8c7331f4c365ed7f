#include "study/protocol/counterbalance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace ocelli {
namespace {

/// Between the cells of a table of so many, as slots come one by one.
class CellCounts {
 public:
  explicit CellCounts(size_t cells) : counts_(cells, 0) {}
  void count(int cell) { ++counts_.at(static_cast<size_t>(cell)); }
  int difference() const {
    const auto [least, most] = std::minmax_element(counts_.begin(), counts_.end());
    return *most - *least;
  }

 private:
  std::vector<int> counts_;
};

struct LargestDifferences {
  int singles = 0;
  int withOrder = 0;
  int viewAndAssignment = 0;
  int all = 0;
};

/// Over the slots 0 to n - 1 for every n up to `slots`.
LargestDifferences largestDifferences(int orders, int session, int slots) {
  const auto count = static_cast<size_t>(orders);
  CellCounts view(2);
  CellCounts order(count);
  CellCounts assignment(2);
  CellCounts viewOrder(2 * count);
  CellCounts orderAssignment(2 * count);
  CellCounts viewAssignment(4);
  CellCounts all(4 * count);
  LargestDifferences largest;
  for (int slot = 0; slot < slots; ++slot) {
    const SlotLevels levels = levelsOf(slot, session, orders);
    view.count(levels.firstView);
    order.count(levels.order);
    assignment.count(levels.assignment);
    viewOrder.count(2 * levels.order + levels.firstView);
    orderAssignment.count(2 * levels.order + levels.assignment);
    viewAssignment.count(2 * levels.firstView + levels.assignment);
    all.count(4 * levels.order + 2 * levels.firstView + levels.assignment);
    largest.singles = std::max({largest.singles, view.difference(), order.difference(), assignment.difference()});
    largest.withOrder = std::max({largest.withOrder, viewOrder.difference(), orderAssignment.difference()});
    largest.viewAndAssignment = std::max(largest.viewAndAssignment, viewAssignment.difference());
    largest.all = std::max(largest.all, all.difference());
  }
  return largest;
}

TEST(Counterbalance, FillsAllCombinationsEvenlyForAnyNumberOfSubjects) {
  for (const int orders : {1, 2, 3, 4, 5, 7, 8, 9, 11, 12, 13, 16, 20, 28, 36}) {
    for (const int session : {0, 1, 2}) {
      const LargestDifferences largest = largestDifferences(orders, session, 400);
      EXPECT_EQ(largest.singles, 1) << orders;
      EXPECT_EQ(largest.withOrder, 1) << orders;
      EXPECT_EQ(largest.all, 1) << orders;
      // With two orders one pair has to give: see counterbalance.h.
      EXPECT_EQ(largest.viewAndAssignment, orders == 2 ? 2 : 1) << orders;
    }
  }
}

TEST(Counterbalance, CompletesTwoOrdersAfterEightSlots) {
  std::map<std::pair<int, int>, int> counts;
  for (int slot = 0; slot < 8; ++slot) {
    const SlotLevels levels = levelsOf(slot, 0, 2);
    ++counts[{levels.firstView, levels.assignment}];
  }
  for (const auto& [levels, count] : counts) {
    EXPECT_EQ(count, 2);
  }
  EXPECT_EQ(counts.size(), 4u);
}

TEST(Counterbalance, SwapsViewsFromSessionToSession) {
  for (int slot = 0; slot < 24; ++slot) {
    const SlotLevels first = levelsOf(slot, 0, 3);
    const SlotLevels second = levelsOf(slot, 1, 3);
    EXPECT_NE(first.firstView, second.firstView);
    EXPECT_NE(first.assignment, second.assignment);
    EXPECT_EQ(first, levelsOf(slot, 2, 3));
  }
}

TEST(BlockOrders, HaveEachBlockOnceAndEquallyOftenInEachPlace) {
  for (int blocks = 1; blocks <= 20; ++blocks) {
    const std::vector<std::vector<int>> orders = blockOrders(blocks);
    std::map<std::pair<int, size_t>, int> inPlace;
    for (const std::vector<int>& order : orders) {
      EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), static_cast<size_t>(blocks));
      EXPECT_EQ(order.size(), static_cast<size_t>(blocks));
      for (size_t place = 0; place < order.size(); ++place) {
        ++inPlace[{order[place], place}];
      }
    }
    EXPECT_EQ(inPlace.size(), static_cast<size_t>(blocks * blocks));
    for (const auto& [place, count] : inPlace) {
      EXPECT_EQ(count, static_cast<int>(orders.size()) / blocks);
    }
    EXPECT_EQ(std::set<std::vector<int>>(orders.begin(), orders.end()).size(), orders.size());
    levelsOf(0, 0, static_cast<int>(orders.size()));  // takes as many
  }
}

TEST(BlockOrders, HaveEachBlockEquallyOftenBeforeEachOtherWhereTheirNumberIsEven) {
  for (const int blocks : {2, 4, 6, 8, 10}) {
    const std::vector<std::vector<int>> orders = blockOrders(blocks);
    std::map<std::pair<int, int>, size_t> follows;
    for (const std::vector<int>& order : orders) {
      for (size_t i = 1; i < order.size(); ++i) {
        ++follows[{order[i - 1], order[i]}];
      }
    }
    EXPECT_EQ(follows.size(), static_cast<size_t>(blocks * (blocks - 1)));
    for (const auto& [pair, count] : follows) {
      EXPECT_EQ(count, orders.size() / static_cast<size_t>(blocks));
    }
  }
}

}  // namespace
}  // namespace ocelli
