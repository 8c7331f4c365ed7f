#include "study/protocol/schedule.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "study/protocol/condition_order.h"
#include "study/protocol/counterbalance.h"
#include "study/protocol/staircase_trials.h"

namespace ocelli {
namespace {

/// A seed of several numbers and a name. Of 53 bits, so that JSON and databases hold it exactly.
uint64_t seedOf(uint64_t seed, uint64_t first, const std::string& name, uint64_t second) {
  uint64_t mixed = Random(seed).next() ^ first;
  for (const char c : name) {
    mixed = Random(mixed).next() ^ static_cast<unsigned char>(c);
  }
  return Random(Random(mixed).next() ^ second).next() >> 11;
}

/// Takes the cases of the two views in turn.
std::vector<CaseInCondition> inTurn(const std::vector<int>& first, const std::vector<int>& second,
                                    TrialView firstView) {
  std::vector<CaseInCondition> trials;
  for (size_t i = 0; i < first.size() + second.size(); ++i) {
    const bool isFirst = i % 2 == 0;
    trials.push_back({(isFirst ? first : second)[i / 2], isFirst ? firstView : otherThan(firstView)});
  }
  return trials;
}

std::vector<CaseInCondition> balancedTrials(int cases, ViewsOfCases views, TrialView firstView, int assignment,
                                            Random& random) {
  std::vector<int> first;
  std::vector<int> second;
  for (int i = 0; i < cases; ++i) {
    const bool isLastOfOdd = cases % 2 == 1 && i == cases - 1;
    // The assignment tells which view the even cases have, whatever view comes first.
    const TrialView view = isLastOfOdd ? firstView : kViews[static_cast<size_t>((i + assignment) % 2)];
    (view == firstView ? first : second).push_back(i);
  }
  random.shuffle(first);
  random.shuffle(second);
  std::vector<CaseInCondition> trials = inTurn(first, second, firstView);
  if (views == ViewsOfCases::kOne) {
    return trials;
  }
  // Views go on taking turns, and the other view of those with the view that comes next are those of the last trial.
  const int last = trials.back().caseIndex;
  const bool lastWasFirst = trials.back().view == firstView;
  std::vector<int> next = lastWasFirst ? first : second;
  std::vector<int> other = lastWasFirst ? second : first;
  random.shuffle(next);
  random.shuffle(other);
  if (next.front() == last && next.size() > 1) {
    std::swap(next.front(), next[1 + random.below(next.size() - 1)]);
  }
  const std::vector<CaseInCondition> again = inTurn(next, other, otherThan(trials.back().view));
  trials.insert(trials.end(), again.begin(), again.end());
  return trials;
}

std::vector<CaseInCondition> alternatingTrials(int cases, ViewsOfCases views) {
  std::vector<CaseInCondition> trials;
  const int count = views == ViewsOfCases::kAll ? 2 * cases : cases;
  for (int i = 0; i < count; ++i) {
    const int shift = i >= cases && cases % 2 == 0 ? 1 : 0;
    trials.push_back({(i + shift) % cases, kViews[static_cast<size_t>(i % 2)]});
  }
  return trials;
}

TrialView firstViewOf(const SessionSchedule& schedule, const ProtocolBlock& block) {
  return block.order == TrialOrder::kBalanced ? schedule.firstView : TrialView::kReference;
}

/// How many conditions after the first one of the block another one comes.
size_t placeAfter(TrialView first, TrialView view, size_t conditions) {
  return (indexOfCondition(view) + conditions - indexOfCondition(first)) % conditions;
}

/// What the slot decides: of a pair by its own layout, of other numbers of conditions by Williams designs.
class BlockTrials {
 public:
  BlockTrials(const Protocol& protocol, int slot, int sessionsBefore, int orders)
      : conditions_(static_cast<int>(protocol.conditions.names.size())) {
    if (conditions_ == 2) {
      pair_ = levelsOf(slot, sessionsBefore, orders);
    } else {
      levels_ = conditionLevelsOf(slot, sessionsBefore, conditions_, orders);
    }
  }

  TrialView firstView() const {
    return conditionAt(static_cast<size_t>(conditions_ == 2 ? pair_.firstView : levels_.first));
  }
  int order() const { return conditions_ == 2 ? pair_.order : levels_.order; }
  std::vector<CaseInCondition> of(const ProtocolBlock& block, Random& random) const {
    if (block.staircase) {
      const TrialView first = block.order == TrialOrder::kBalanced ? firstView() : TrialView::kReference;
      return staircaseTrials(block, static_cast<size_t>(conditions_), first, random);
    }
    const int cases = block.task->caseCount();
    const bool all = block.views == ViewsOfCases::kAll;
    if (block.order == TrialOrder::kAlternating) {
      return conditions_ == 2 ? alternatingTrials(cases, block.views) : trialsInTurn(cases, conditions_, all);
    }
    return conditions_ == 2 ? balancedTrials(cases, block.views, firstView(), pair_.assignment, random)
                            : trialsInRuns(cases, conditions_, all, levels_, random);
  }

 private:
  int conditions_;
  SlotLevels pair_{};
  ConditionLevels levels_{};
};

/// What seeds are made of.
uint64_t sessionsBefore(const SessionSchedule& schedule) {
  return static_cast<uint64_t>(schedule.session - 1);
}

}  // namespace

bool isInSession(const ProtocolBlock& block, int session) {
  return block.sessions.empty() ||
         std::find(block.sessions.begin(), block.sessions.end(), session) != block.sessions.end();
}

std::vector<std::vector<int>> blockOrdersOf(const Protocol& protocol, int session) {
  std::vector<int> blocks;
  for (size_t i = 0; i < protocol.blocks.size(); ++i) {
    if (isInSession(protocol.blocks[i], session)) {
      blocks.push_back(static_cast<int>(i));
    }
  }
  if (!protocol.shuffleBlocks || blocks.empty()) {
    return {blocks};
  }
  std::vector<std::vector<int>> orders = blockOrders(static_cast<int>(blocks.size()));
  for (std::vector<int>& order : orders) {
    for (int& block : order) {
      block = blocks[static_cast<size_t>(block)];
    }
    // A subject has another order in the next session, and each block is as often in each place as before.
    std::rotate(order.begin(), order.begin() + (session - 1) % static_cast<int>(order.size()), order.end());
  }
  return orders;
}

SessionSchedule scheduleOf(const Protocol& protocol, int slot, int session, uint64_t seed) {
  if (session < 1 || session > protocol.sessions) {
    throw InputError(fmt::format("there is no session {}: the protocol has {}", session, protocol.sessions),
                     protocol.name, fmt::format("choose one from 1 to {}", protocol.sessions));
  }
  if (slot < 0) {
    throw InputError(fmt::format("there is no slot {}", slot), protocol.name, "choose a number from 0");
  }
  const std::vector<std::vector<int>> orders = blockOrdersOf(protocol, session);
  const BlockTrials trialsOfBlocks(protocol, slot, session - 1, static_cast<int>(orders.size()));
  SessionSchedule schedule;
  schedule.slot = slot;
  schedule.session = session;
  schedule.seed = seed;
  schedule.firstView = trialsOfBlocks.firstView();
  schedule.blockOrder = orders[static_cast<size_t>(trialsOfBlocks.order())];
  for (const int index : schedule.blockOrder) {
    const ProtocolBlock& block = protocol.blocks[static_cast<size_t>(index)];
    Random random(seedOf(seed, sessionsBefore(schedule), block.name + "/order", static_cast<uint64_t>(slot)));
    uint64_t place = 0;
    for (const CaseInCondition& trial : trialsOfBlocks.of(block, random)) {
      const uint64_t own = block.staircase ? place++ : static_cast<uint64_t>(trial.caseIndex);
      schedule.trials.push_back({static_cast<int>(schedule.trials.size()), index, block.taskName, trial.caseIndex,
                                 trial.view, seedOf(seed, sessionsBefore(schedule), block.name, own), false});
    }
  }
  return schedule;
}

std::vector<std::optional<TrialView>> practiceRounds(const SessionSchedule& schedule, const Protocol& protocol,
                                                     int block) {
  const ProtocolBlock& of = protocol.blocks.at(static_cast<size_t>(block));
  if (!of.practice) {
    return {};
  }
  if (!of.practice->eachView) {
    return {std::nullopt};
  }
  const TrialView first = firstViewOf(schedule, of);
  const size_t conditions = protocol.conditions.names.size();
  std::vector<std::optional<TrialView>> rounds;
  for (size_t i = 0; i < conditions; ++i) {
    rounds.emplace_back(conditionAt((indexOfCondition(first) + i) % conditions));
  }
  return rounds;
}

TrialPlan practiceTrial(const SessionSchedule& schedule, const Protocol& protocol, int block, int number,
                        std::optional<TrialView> round) {
  const ProtocolBlock& of = protocol.blocks.at(static_cast<size_t>(block));
  OC_CHECK(of.practice.has_value() && number >= 0, "only blocks with practice have practice trials");
  const int cases = of.practice->task->caseCount();
  // With an even number of cases each gets its other view in the next round.
  const int shift = cases % 2 == 0 ? number / cases : 0;
  const TrialView first = firstViewOf(schedule, of);
  const size_t conditions = protocol.conditions.names.size();
  TrialPlan plan;
  plan.index = -1;
  plan.block = block;
  plan.task = of.taskName;
  plan.caseIndex = number % cases;
  if (round) {
    plan.view = *round;
  } else if (conditions == 2) {
    plan.view = (number + shift) % 2 == 0 ? first : otherThan(first);
  } else {
    // In each round of the cases every one has its next condition.
    const auto turn = static_cast<size_t>(number % cases + number / cases);
    plan.view = conditionAt((indexOfCondition(first) + turn) % conditions);
  }
  // What is random in one round is not what was in the ones before.
  const size_t before = round ? placeAfter(first, *round, conditions) * static_cast<size_t>(of.practice->maxTrials) : 0;
  plan.seed = seedOf(schedule.seed, sessionsBefore(schedule), of.name + "/practice",
                     static_cast<uint64_t>(before) + static_cast<uint64_t>(number));
  plan.practice = true;
  return plan;
}

std::string jsonText(const SessionSchedule& schedule, const ViewConditions& conditions) {
  nlohmann::ordered_json json;
  json["slot"] = schedule.slot;
  json["session"] = sessionsBefore(schedule);  // as databases have it
  json["seed"] = schedule.seed;
  json["first_view"] = conditions.nameOf(schedule.firstView);
  json["block_order"] = schedule.blockOrder;
  json["trials"] = nlohmann::ordered_json::array();
  for (const TrialPlan& trial : schedule.trials) {
    json["trials"].push_back({{"index", trial.index},
                              {"block", trial.block},
                              {"task", trial.task},
                              {"case", trial.caseIndex},
                              {"view", conditions.nameOf(trial.view)},
                              {"seed", trial.seed}});
  }
  return json.dump();
}

}  // namespace ocelli
