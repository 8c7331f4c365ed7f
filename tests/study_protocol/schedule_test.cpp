#include "study/protocol/schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "oc_core/base/error.h"
#include "tests/study_protocol/sham_protocol.h"

namespace ocelli::test {
namespace {

using testing::ElementsAre;

constexpr auto kAlternating = TrialOrder::kAlternating;
constexpr auto kBalancedSchedule = TrialOrder::kBalanced;
constexpr auto kBothViews = ViewsOfCases::kAll;
constexpr auto kOneView = ViewsOfCases::kOne;

std::vector<std::string> written(const SessionSchedule& schedule) {
  std::vector<std::string> list;
  for (const TrialPlan& trial : schedule.trials) {
    list.push_back(std::to_string(trial.caseIndex + 1).append(trial.view == TrialView::kReference ? "p" : "g"));
  }
  return list;
}

SessionSchedule oneBlock(int cases, TrialOrder order, ViewsOfCases views, int slot = 0, int session = 1) {
  return scheduleOf(shamProtocol({shamBlock("only", cases, order, views)}), slot, session, 1);
}

TEST(Schedule, AlternatesViewsInTheOrderOfTheFile) {
  EXPECT_THAT(written(oneBlock(5, kAlternating, kOneView)), ElementsAre("1p", "2g", "3p", "4g", "5p"));
  EXPECT_THAT(written(oneBlock(3, kAlternating, kBothViews)), ElementsAre("1p", "2g", "3p", "1g", "2p", "3g"));
  // With an even number the second pass begins with the second case, so that each gets its other view.
  EXPECT_THAT(written(oneBlock(4, kAlternating, kBothViews)),
              ElementsAre("1p", "2g", "3p", "4g", "2p", "3g", "4p", "1g"));
  EXPECT_EQ(oneBlock(4, kAlternating, kBothViews), oneBlock(4, kAlternating, kBothViews));
  EXPECT_EQ(written(oneBlock(4, kAlternating, kBothViews, 7, 3)), written(oneBlock(4, kAlternating, kBothViews)));
}

TEST(Schedule, ShowsEachCaseInEachViewOnceOrInOneView) {
  for (const TrialOrder order : {kAlternating, kBalancedSchedule}) {
    for (int cases = 1; cases <= 13; ++cases) {
      for (int slot = 0; slot < 8; ++slot) {
        const std::vector<std::string> both = written(oneBlock(cases, order, kBothViews, slot));
        EXPECT_EQ(both.size(), static_cast<size_t>(2 * cases));
        EXPECT_EQ(std::set<std::string>(both.begin(), both.end()).size(), both.size());
        std::set<int> shown;
        for (const TrialPlan& trial : oneBlock(cases, order, kOneView, slot).trials) {
          EXPECT_TRUE(shown.insert(trial.caseIndex).second);
        }
        EXPECT_EQ(shown.size(), static_cast<size_t>(cases));
      }
    }
  }
}

TEST(Schedule, TakesViewsInTurnAndNoCaseTwiceInARow) {
  for (int cases = 3; cases <= 12; ++cases) {
    for (int slot = 0; slot < 60; ++slot) {
      for (const ViewsOfCases views : {kBothViews, kOneView}) {
        const SessionSchedule schedule = oneBlock(cases, kBalancedSchedule, views, slot, 1 + slot % 3);
        EXPECT_EQ(schedule.trials.front().view, schedule.firstView);
        for (size_t i = 1; i < schedule.trials.size(); ++i) {
          EXPECT_NE(schedule.trials[i].view, schedule.trials[i - 1].view);
          EXPECT_NE(schedule.trials[i].caseIndex, schedule.trials[i - 1].caseIndex);
        }
      }
    }
  }
}

TEST(Schedule, ShowsAllCasesBeforeOneComesAgain) {
  const SessionSchedule schedule = oneBlock(12, kBalancedSchedule, kBothViews, 5);
  std::set<int> shown;
  for (size_t i = 0; i < 12; ++i) {
    shown.insert(schedule.trials[i].caseIndex);
  }
  EXPECT_EQ(shown.size(), 12u);
}

TEST(Schedule, ShufflesAnewForEachSubjectAndSession) {
  std::set<std::vector<std::string>> orders;
  for (int slot = 0; slot < 40; ++slot) {
    for (int session = 1; session <= 3; ++session) {
      orders.insert(written(oneBlock(12, kBalancedSchedule, kBothViews, slot, session)));
    }
  }
  // Two of 120 are alike by chance once in 1e6 studies: (6! 6!)^2 orders, and more.
  EXPECT_EQ(orders.size(), 120u);
}

TEST(Schedule, PutsEachCaseInEachPlaceAboutEquallyOften) {
  constexpr int kSlots = 1200;
  std::map<std::pair<int, size_t>, int> counts;
  for (int slot = 0; slot < kSlots; ++slot) {
    const SessionSchedule schedule = oneBlock(6, kBalancedSchedule, kOneView, slot);
    for (size_t i = 0; i < 6; ++i) {
      ++counts[{schedule.trials[i].caseIndex, i}];
    }
  }
  EXPECT_EQ(counts.size(), 36u);
  for (const auto& [cell, count] : counts) {
    EXPECT_NEAR(count, kSlots / 6, 65);  // five standard deviations of a binomial count of 1/6 among 1200
  }
}

TEST(Schedule, SeedsTrialsBySessionBlockAndCaseAndNotBySubject) {
  const Protocol protocol =
      shamProtocol({shamBlock("a", 4, kBalancedSchedule, kBothViews), shamBlock("b", 4, kBalancedSchedule, kOneView)});
  std::map<std::tuple<int, int, int>, std::set<uint64_t>> seeds;
  std::set<uint64_t> all;
  for (int session = 1; session <= 3; ++session) {
    for (int slot = 0; slot < 9; ++slot) {
      for (const TrialPlan& trial : scheduleOf(protocol, slot, session, 7).trials) {
        seeds[{session, trial.block, trial.caseIndex}].insert(trial.seed);
        all.insert(trial.seed);
        EXPECT_LT(trial.seed, uint64_t{1} << 53);
      }
    }
  }
  for (const auto& [item, of] : seeds) {
    EXPECT_EQ(of.size(), 1u);
  }
  EXPECT_EQ(all.size(), 3u * 2 * 4);
  EXPECT_NE(scheduleOf(protocol, 0, 1, 8).trials[0].seed, scheduleOf(protocol, 0, 1, 7).trials[0].seed);
}

TEST(Schedule, LeavesBlocksInTheirOrderUnlessTheyAreShuffled) {
  std::vector<ProtocolBlock> blocks;
  for (const char* name : {"a", "b", "c"}) {
    blocks.push_back(shamBlock(name, 2, kBalancedSchedule, kOneView));
  }
  std::set<std::vector<int>> shuffled;
  for (int slot = 0; slot < 9; ++slot) {
    EXPECT_THAT(scheduleOf(shamProtocol(blocks, false), slot, 1, 1).blockOrder, ElementsAre(0, 1, 2));
    const SessionSchedule schedule = scheduleOf(shamProtocol(blocks), slot, 1, 1);
    shuffled.insert(schedule.blockOrder);
    EXPECT_NE(schedule.blockOrder, scheduleOf(shamProtocol(blocks), slot, 2, 1).blockOrder);
    for (size_t i = 0; i < schedule.trials.size(); ++i) {
      EXPECT_EQ(schedule.trials[i].index, static_cast<int>(i));
      EXPECT_EQ(schedule.trials[i].block, schedule.blockOrder[i / 2]);
    }
  }
  EXPECT_EQ(shuffled.size(), 3u);
}

TEST(Schedule, HasTheBlocksOfItsSession) {
  Protocol protocol =
      shamProtocol({shamBlock("a", 2, kBalancedSchedule, kOneView), shamBlock("b", 2, kBalancedSchedule, kOneView),
                    shamBlock("c", 2, kBalancedSchedule, kOneView)},
                   false);
  protocol.blocks[1].sessions = {1, 3};
  EXPECT_THAT(scheduleOf(protocol, 0, 1, 1).blockOrder, ElementsAre(0, 1, 2));
  EXPECT_THAT(scheduleOf(protocol, 0, 2, 1).blockOrder, ElementsAre(0, 2));
}

TEST(Schedule, RefusesSessionsAndSlotsThatAreNone) {
  const Protocol protocol = shamProtocol({shamBlock("a", 2, kBalancedSchedule, kOneView)});
  EXPECT_THROW(scheduleOf(protocol, 0, 4, 1), InputError);
  EXPECT_THROW(scheduleOf(protocol, 0, 0, 1), InputError);
  EXPECT_THROW(scheduleOf(protocol, -1, 1, 1), InputError);
}

TEST(Schedule, PracticesCasesAndViewsInTurn) {
  Protocol protocol = shamProtocol({shamBlock("a", 2, kBalancedSchedule, kOneView)});
  protocol.blocks[0].practice = ProtocolPractice{shamTask(2), 2, 8};
  for (int slot = 0; slot < 2; ++slot) {
    const SessionSchedule schedule = scheduleOf(protocol, slot, 1, 1);
    std::set<std::pair<int, TrialView>> seen;
    std::set<uint64_t> seeds;
    for (int i = 0; i < 4; ++i) {
      const TrialPlan plan = practiceTrial(schedule, protocol, 0, i);
      seen.insert({plan.caseIndex, plan.view});
      seeds.insert(plan.seed);
      EXPECT_TRUE(plan.practice);
      EXPECT_EQ(plan.index, -1);
    }
    EXPECT_EQ(seen.size(), 4u);
    EXPECT_EQ(seeds.size(), 4u);
    EXPECT_EQ(practiceTrial(schedule, protocol, 0, 0).view, schedule.firstView);
    EXPECT_NE(practiceTrial(schedule, protocol, 0, 1).view, schedule.firstView);
  }
}

TEST(Schedule, IsWrittenAsJson) {
  const SessionSchedule schedule = oneBlock(3, kBalancedSchedule, kOneView, 4, 2);
  const nlohmann::json json = nlohmann::json::parse(jsonText(schedule, defaultConditions()));
  EXPECT_EQ(json.at("slot"), 4);
  EXPECT_EQ(json.at("session"), 1);  // from 0, as in databases of all versions
  EXPECT_EQ(json.at("trials").size(), 3u);
  EXPECT_EQ(json.at("trials").at(2).at("seed"), schedule.trials[2].seed);
  EXPECT_EQ(json.at("trials").at(2).at("view"), defaultConditions().nameOf(schedule.trials[2].view));
}

}  // namespace
}  // namespace ocelli::test
