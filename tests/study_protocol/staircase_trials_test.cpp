// Trials of staircases: conditions in rounds, and which case comes when.
#include "study/protocol/staircase_trials.h"

#include <gtest/gtest.h>

#include <set>

#include "study/protocol/schedule.h"

namespace ocelli {
namespace {

/// Goes to the level that is the number of answers so far: tells what it was asked.
class CountingStaircase : public Staircase {
 public:
  size_t next(std::span<const LevelAnswer> before) const override { return before.size() % 4; }
  std::optional<double> threshold(std::span<const LevelAnswer> answers) const override {
    double right = 0;
    for (const LevelAnswer& answer : answers) {
      right += answer.correct ? 1 : 0;
    }
    return answers.empty() ? std::nullopt : std::optional(right);
  }
  std::string summary() const override { return "counts"; }
};

class FourCases : public TaskBlock {
 public:
  int caseCount() const override { return 4; }
  CaseInfo caseInfo(int) const override { return {}; }
  std::string answerOf(const TrialPlan&) const override { return "a"; }
  std::unique_ptr<TrialRun> start(const TrialPlan&, const TrialScreen&) const override { return nullptr; }
};

Protocol steps(TrialOrder order = TrialOrder::kBalanced) {
  Protocol protocol;
  protocol.name = "steps";
  ProtocolBlock block;
  block.name = "block";
  block.taskName = "steps";
  block.task = std::make_shared<FourCases>();
  block.order = order;
  auto staircase = std::make_shared<BlockStaircase>();
  staircase->rule = std::make_shared<CountingStaircase>();
  staircase->trials = 10;
  staircase->levels = {1, 2, 3, 4};
  staircase->cases = {3, 1, 0, 2};
  block.staircase = staircase;
  protocol.blocks = {block};
  return protocol;
}

TEST(StaircaseTrials, EachRoundHasAllConditionsAndTheFirstBeginsWithThatOfTheSlot) {
  const Protocol protocol = steps();
  std::set<TrialView> firsts;
  bool swaps = false;
  for (int slot = 0; slot < 4; ++slot) {
    const SessionSchedule schedule = scheduleOf(protocol, slot, 1, 3);
    ASSERT_EQ(schedule.trials.size(), 20u);
    EXPECT_EQ(schedule.trials.front().view, schedule.firstView);
    firsts.insert(schedule.firstView);
    std::set<uint64_t> seeds;
    for (size_t i = 0; i < schedule.trials.size(); i += 2) {
      EXPECT_NE(schedule.trials[i].view, schedule.trials[i + 1].view);
      swaps = swaps || schedule.trials[i].view != schedule.firstView;
      seeds.insert(schedule.trials[i].seed);
      seeds.insert(schedule.trials[i + 1].seed);
    }
    EXPECT_EQ(seeds.size(), 20u) << "what is random in one trial is not what was in another";
    EXPECT_EQ(schedule, scheduleOf(protocol, slot, 1, 3));
  }
  EXPECT_EQ(firsts.size(), 2u);
  EXPECT_TRUE(swaps);
  for (const TrialPlan& plan : scheduleOf(steps(TrialOrder::kAlternating), 1, 1, 3).trials) {
    EXPECT_EQ(plan.view, plan.index % 2 == 0 ? TrialView::kReference : TrialView::kOther);
  }
}

TEST(StaircaseTrials, TheCaseFollowsFromTheTrialsBeforeOfTheSameCondition) {
  const Protocol protocol = steps();
  const SessionSchedule schedule = scheduleOf(protocol, 0, 1, 3);
  AnsweredCases answered;
  std::map<TrialView, size_t> seen;
  for (const TrialPlan& plan : schedule.trials) {
    const TrialPlan shown = shownPlan(protocol, plan, answered);
    EXPECT_EQ(shown.caseIndex, protocol.blocks[0].staircase->cases[seen[plan.view] % 4]);
    ++seen[plan.view];
    answered[plan.index] = {plan.block, plan.view, shown.caseIndex, plan.index % 3 == 0};
  }
  // Any trial again, with all answers known: it shows what it showed.
  for (const TrialPlan& plan : schedule.trials) {
    EXPECT_EQ(shownPlan(protocol, plan, answered).caseIndex, answered.at(plan.index).caseIndex);
    EXPECT_EQ(shownPlan(protocol, shownPlan(protocol, plan, answered), answered), shownPlan(protocol, plan, answered));
  }
  TrialPlan practice = schedule.trials.front();
  practice.practice = true;
  EXPECT_EQ(shownPlan(protocol, practice, answered), practice);
}

TEST(StaircaseTrials, TellsWhatTheStaircaseOfAConditionFound) {
  const Protocol protocol = steps();
  EXPECT_EQ(staircaseState(protocol, 0, TrialView::kReference, {}).trials, 0);
  EXPECT_EQ(thresholdText(staircaseState(protocol, 0, TrialView::kReference, {})), "no threshold yet");
  const AnsweredCases answered{{0, {0, TrialView::kReference, 3, true}},
                               {1, {0, TrialView::kOther, 3, true}},
                               {2, {0, TrialView::kReference, 1, true}},
                               {5, {1, TrialView::kReference, 1, true}}};
  const StaircaseState state = staircaseState(protocol, 0, TrialView::kReference, answered);
  EXPECT_EQ(state.trials, 2);
  EXPECT_EQ(thresholdText(state), "2");
}

}  // namespace
}  // namespace ocelli
