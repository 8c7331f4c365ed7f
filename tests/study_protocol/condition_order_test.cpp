// Orders of one to sixteen conditions: Williams designs, over slots and cases.
#include "study/protocol/condition_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "study/protocol/balance.h"
#include "tests/study_protocol/sham_protocol.h"

namespace ocelli::test {
namespace {

constexpr auto kInAll = ViewsOfCases::kAll;
constexpr auto kInOne = ViewsOfCases::kOne;

Protocol protocolOf(size_t conditions, int cases, ViewsOfCases views, int blocks = 1) {
  std::vector<ProtocolBlock> all;
  for (int i = 0; i < blocks; ++i) {
    all.push_back(shamBlock("block " + std::to_string(i + 1), cases, TrialOrder::kBalanced, views));
  }
  Protocol protocol = shamProtocol(std::move(all));
  protocol.conditions.names.list.clear();
  for (size_t i = 0; i < conditions; ++i) {
    protocol.conditions.names.list.push_back({"c" + std::to_string(i), "condition " + std::to_string(i)});
  }
  return protocol;
}

/// How often each follows each, in rows or sequences.
std::map<std::pair<int, int>, int> neighborsOf(const std::vector<std::vector<int>>& rows) {
  std::map<std::pair<int, int>, int> pairs;
  for (const std::vector<int>& row : rows) {
    for (size_t i = 1; i < row.size(); ++i) {
      ++pairs[{row[i - 1], row[i]}];
    }
  }
  return pairs;
}

/// Largest and smallest count over all ordered pairs of different conditions.
std::pair<int, int> rangeOfPairs(std::map<std::pair<int, int>, int> pairs, int conditions) {
  int least = 1 << 30;
  int most = 0;
  for (int a = 0; a < conditions; ++a) {
    for (int b = 0; b < conditions; ++b) {
      if (a != b) {
        const int count = pairs[std::pair(a, b)];
        least = std::min(least, count);
        most = std::max(most, count);
      }
    }
  }
  return {least, most};
}

std::vector<int> viewsOf(const SessionSchedule& schedule) {
  std::vector<int> views;
  for (const TrialPlan& trial : schedule.trials) {
    views.push_back(static_cast<int>(indexOfCondition(trial.view)));
  }
  return views;
}

class Conditions : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(ConditionOrder, Conditions, testing::Range(1, 17));

TEST_P(Conditions, StandInRowsOnceAtEachPlaceAndOnceBeforeEachOther) {
  const int conditions = GetParam();
  const std::vector<std::vector<int>> rows = williamsRows(conditions);
  const int each = conditions % 2 == 0 ? 1 : 2;
  ASSERT_EQ(std::ssize(rows), each * conditions);
  for (size_t place = 0; place < static_cast<size_t>(conditions); ++place) {
    std::map<int, int> counts;
    for (const std::vector<int>& row : rows) {
      ++counts[row[place]];
    }
    EXPECT_EQ(std::ssize(counts), conditions);
    for (const auto& [condition, count] : counts) {
      EXPECT_EQ(count, each) << condition << " at place " << place;
    }
  }
  if (conditions > 1) {
    EXPECT_EQ(rangeOfPairs(neighborsOf(rows), conditions), std::pair(each, each));
  }
}

TEST_P(Conditions, AreBalancedOverSlots) {
  const int conditions = GetParam();
  if (conditions == 2) {
    GTEST_SKIP() << "a pair has a layout of its own (counterbalance_test.cpp)";
  }
  // One run of cases, and one that leaves some over.
  for (const int cases : {conditions, conditions + 2}) {
    const Protocol protocol = protocolOf(static_cast<size_t>(conditions), cases, kInAll);
    const int slots = conditions % 2 == 0 ? conditions : 2 * conditions;
    std::vector<std::vector<int>> sequences;
    for (int slot = 0; slot < slots; ++slot) {
      const SessionSchedule schedule = scheduleOf(protocol, slot, 1, 5);
      sequences.push_back(viewsOf(schedule));
      std::set<std::pair<int, TrialView>> seen;
      for (size_t i = 0; i < schedule.trials.size(); ++i) {
        EXPECT_TRUE(seen.insert({schedule.trials[i].caseIndex, schedule.trials[i].view}).second) << "each case once";
      }
      EXPECT_EQ(std::ssize(seen), conditions * cases);
      EXPECT_EQ(indexOfCondition(schedule.firstView), static_cast<size_t>(sequences.back().front()));
    }
    for (size_t place = 0; place < sequences.front().size(); ++place) {
      std::map<int, int> counts;
      for (const std::vector<int>& sequence : sequences) {
        ++counts[sequence[place]];
      }
      for (int condition = 0; condition < conditions; ++condition) {
        EXPECT_EQ(counts[condition], slots / conditions) << condition << " at place " << place << ", " << cases;
      }
    }
    if (conditions > 1 && cases == conditions) {
      // Within runs, and across the ends of the k - 1 runs, each difference once.
      const auto [least, most] = rangeOfPairs(neighborsOf(sequences), conditions);
      EXPECT_EQ(least, most);
      EXPECT_EQ(least, slots * (conditions * conditions - 1) / (conditions * (conditions - 1)));
    }
  }
}

TEST_P(Conditions, ShowEachCaseEquallyOftenWhereItIsSeenOnce) {
  const int conditions = GetParam();
  if (conditions == 2) {
    GTEST_SKIP() << "a pair has a layout of its own (counterbalance_test.cpp)";
  }
  const Protocol protocol = protocolOf(static_cast<size_t>(conditions), 2 * conditions + 1, kInOne);
  std::map<std::pair<int, size_t>, int> counts;
  std::map<std::pair<int, std::pair<int, size_t>>, int> byRun;
  for (int slot = 0; slot < conditions * conditions; ++slot) {
    const SessionSchedule schedule = scheduleOf(protocol, slot, 1, 5);
    EXPECT_EQ(std::ssize(schedule.trials), 2 * conditions + 1);
    for (const TrialPlan& trial : schedule.trials) {
      ++counts[{trial.caseIndex, indexOfCondition(trial.view)}];
      ++byRun[{slot / conditions, {trial.caseIndex, indexOfCondition(trial.view)}}];
    }
  }
  for (const auto& [cell, count] : counts) {
    EXPECT_EQ(count, conditions) << "case " << cell.first << " in condition " << cell.second;
  }
  for (const auto& [cell, count] : byRun) {
    EXPECT_EQ(count, 1) << "in each run of as many slots as there are conditions";
  }
}

TEST_P(Conditions, GoWithEachOrderOfBlocks) {
  const int conditions = GetParam();
  for (const int orders : {1, 2, 3, 4, 5, 7, 8, 12}) {
    std::map<std::pair<int, int>, int> firsts;
    std::map<int, int> counts;
    for (int slot = 0; slot < conditions * orders; ++slot) {
      const ConditionLevels levels = conditionLevelsOf(slot, 0, conditions, orders);
      ASSERT_TRUE(levels.order >= 0 && levels.order < orders);
      ++firsts[{levels.first, levels.order}];
      ++counts[levels.order];
    }
    EXPECT_EQ(std::ssize(firsts), conditions * orders) << orders << " orders: each pair once";
    EXPECT_EQ(counts[0], conditions);
    std::map<std::pair<int, int>, int> assignments;
    for (int slot = 0; slot < conditions * conditions * orders; ++slot) {
      const ConditionLevels levels = conditionLevelsOf(slot, 1, conditions, orders);
      ++assignments[{levels.first, levels.assignment}];
    }
    EXPECT_EQ(std::ssize(assignments), conditions * conditions);
    for (const auto& [levels, count] : assignments) {
      EXPECT_EQ(count, orders);
    }
  }
}

TEST(ConditionOrder, SeldomRepeatsACaseAtOnce) {
  const Protocol protocol = protocolOf(4, 8, kInAll);
  for (int slot = 0; slot < 16; ++slot) {
    const SessionSchedule schedule = scheduleOf(protocol, slot, 2, 9);
    for (size_t i = 1; i < schedule.trials.size(); ++i) {
      EXPECT_NE(schedule.trials[i].caseIndex, schedule.trials[i - 1].caseIndex);
      EXPECT_NE(schedule.trials[i].view, schedule.trials[i - 1].view);
    }
  }
}

TEST(ConditionOrder, MovesOnFromSessionToSession) {
  const Protocol protocol = protocolOf(5, 5, kInOne);
  for (int session = 1; session <= 3; ++session) {
    EXPECT_EQ(indexOfCondition(scheduleOf(protocol, 1, session, 5).firstView), static_cast<size_t>(session % 5));
  }
}

TEST(ConditionOrder, PracticesEachCaseInEachCondition) {
  Protocol protocol = protocolOf(3, 3, kInAll);
  protocol.blocks[0].practice = ProtocolPractice{shamTask(2), 1, 8};
  const SessionSchedule schedule = scheduleOf(protocol, 1, 1, 5);
  std::set<std::pair<int, TrialView>> seen;
  for (int number = 0; number < 6; ++number) {
    const TrialPlan plan = practiceTrial(schedule, protocol, 0, number);
    seen.insert({plan.caseIndex, plan.view});
    EXPECT_LT(indexOfCondition(plan.view), 3u);
  }
  EXPECT_EQ(seen.size(), 6u);
  EXPECT_EQ(practiceTrial(schedule, protocol, 0, 0).view, schedule.firstView);
}

TEST(ConditionOrder, IsTheSameForAllInAlternatingBlocks) {
  Protocol protocol = protocolOf(3, 4, kInAll);
  protocol.blocks[0].order = TrialOrder::kAlternating;
  EXPECT_EQ(viewsOf(scheduleOf(protocol, 0, 1, 5)), (std::vector<int>{0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2}));
  EXPECT_EQ(scheduleOf(protocol, 0, 1, 5).trials.back().caseIndex, 3);
  EXPECT_EQ(viewsOf(scheduleOf(protocol, 7, 1, 5)), viewsOf(scheduleOf(protocol, 0, 1, 5)));
}

TEST(ConditionOrder, IsCountedByTheBalance) {
  const std::vector<BalanceTable> tables = balanceOf(protocolOf(5, 5, kInAll, 2), 50, 1, 5);
  std::map<std::string, const BalanceTable*> byFactors;
  for (const BalanceTable& table : tables) {
    byFactors[table.factors] = &table;
  }
  ASSERT_TRUE(byFactors.contains("block 1: view x place in the block"));
  EXPECT_EQ(byFactors["block 1: view x place in the block"]->difference, 0);
  EXPECT_EQ(byFactors["block 1: view x place in the block"]->cells.size(), 125u);
  EXPECT_EQ(byFactors["block 2: view x view of the trial before"]->difference, 0);
  EXPECT_EQ(byFactors["block 2: view x view of the trial before"]->cells.size(), 20u);
  EXPECT_EQ(byFactors["first view"]->difference, 0);
  EXPECT_EQ(byFactors["first view x block order"]->difference, 0);
  // A layout that is not balanced is told: 7 subjects are no multiple of 5.
  EXPECT_GT(balanceOf(protocolOf(5, 5, kInAll, 2), 7, 1, 5).front().difference, 0);
}

}  // namespace
}  // namespace ocelli::test
