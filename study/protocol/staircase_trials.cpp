#include "study/protocol/staircase_trials.h"

#include <fmt/format.h>

#include <algorithm>

namespace ocelli {
namespace {

/// Of the block and condition, in the order of the schedule, before a plan.
std::vector<LevelAnswer> answersBefore(const BlockStaircase& staircase, int block, TrialView view, int plan,
                                       const AnsweredCases& answered) {
  std::vector<LevelAnswer> answers;
  for (const auto& [index, each] : answered) {
    if (index < plan && each.block == block && each.view == view) {
      answers.push_back({staircase.levelOf(each.caseIndex), each.correct});
    }
  }
  return answers;
}

}  // namespace

std::vector<CaseInCondition> staircaseTrials(const ProtocolBlock& block, size_t conditions, TrialView first,
                                             Random& random) {
  std::vector<size_t> round(conditions);
  for (size_t i = 0; i < conditions; ++i) {
    round[i] = (indexOfCondition(first) + i) % conditions;
  }
  std::vector<CaseInCondition> trials;
  for (int number = 0; number < block.staircase->trials; ++number) {
    for (const size_t condition : round) {
      trials.push_back({block.staircase->middleCase(), conditionAt(condition)});
    }
    if (block.order == TrialOrder::kBalanced) {
      random.shuffle(round);
    }
  }
  return trials;
}

TrialPlan shownPlan(const Protocol& protocol, const TrialPlan& plan, const AnsweredCases& answered) {
  const ProtocolBlock& block = protocol.blocks.at(static_cast<size_t>(plan.block));
  if (plan.practice || !block.staircase) {
    return plan;
  }
  const BlockStaircase& staircase = *block.staircase;
  TrialPlan shown = plan;
  const size_t level = staircase.rule->next(answersBefore(staircase, plan.block, plan.view, plan.index, answered));
  shown.caseIndex = staircase.cases.at(level);
  return shown;
}

StaircaseState staircaseState(const Protocol& protocol, int block, TrialView view, const AnsweredCases& answered) {
  const ProtocolBlock& of = protocol.blocks.at(static_cast<size_t>(block));
  StaircaseState state;
  if (!of.staircase || answered.empty()) {
    return state;
  }
  const std::vector<LevelAnswer> answers =
      answersBefore(*of.staircase, block, view, answered.rbegin()->first + 1, answered);
  state.trials = static_cast<int>(answers.size());
  state.threshold = of.staircase->rule->threshold(answers);
  return state;
}

std::string thresholdText(const StaircaseState& state) {
  return state.threshold ? fmt::format("{:.4g}", *state.threshold) : "no threshold yet";
}

}  // namespace ocelli
