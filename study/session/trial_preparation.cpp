#include "study/session/trial_preparation.h"

#include <functional>
#include <set>
#include <utility>

namespace ocelli {
namespace {

struct TrialToPrepare {
  const TaskBlock* task;
  TrialPlan plan;
};

std::vector<TrialToPrepare> trialsOf(const Protocol& protocol, const SessionSchedule& schedule) {
  std::vector<TrialToPrepare> trials;
  for (const int index : schedule.blockOrder) {
    const ProtocolBlock& block = protocol.blocks[static_cast<size_t>(index)];
    for (const ProtocolPage& page : block.instructions) {
      if (page.example) {
        trials.push_back({page.example->task.get(), page.example->plan});
      }
    }
    for (const std::optional<TrialView> round : practiceRounds(schedule, protocol, index)) {
      for (int number = 0; number < block.practice->maxTrials; ++number) {
        trials.push_back({block.practice->task.get(), practiceTrial(schedule, protocol, index, number, round)});
      }
    }
  }
  for (const TrialPlan& plan : schedule.trials) {
    trials.push_back({protocol.blocks[static_cast<size_t>(plan.block)].task.get(), plan});
  }
  return trials;
}

/// Conditions none of whose views takes long need not be asked again.
bool takesLong(const TrialLayout& layout) {
  for (const TrialLayout::View& view : layout.views) {
    if (view.prepare) {
      return true;
    }
  }
  return false;
}

}  // namespace

int prepareTrials(const Protocol& protocol, const SessionSchedule& schedule, const TrialScreen& screen,
                  const Progress& progress) {
  std::set<std::pair<const TaskBlock*, TrialView>> quick;
  const std::vector<TrialToPrepare> trials = trialsOf(protocol, schedule);
  int prepared = 0;
  for (size_t i = 0; i < trials.size(); ++i) {
    const auto& [task, plan] = trials[i];
    if (quick.contains({task, plan.view})) {
      continue;
    }
    const std::unique_ptr<TrialRun> run = task->start(plan, screen);
    const TrialLayout layout = run->layout();
    if (!takesLong(layout)) {
      quick.insert({task, plan.view});
      continue;
    }
    for (const TrialLayout::View& view : layout.views) {
      if (view.prepare) {
        view.prepare(layout, [&](std::string_view stage, double fraction) {
          report(progress, stage, (static_cast<double>(i) + fraction) / static_cast<double>(trials.size()));
        });
        ++prepared;
      }
    }
  }
  return prepared;
}

}  // namespace ocelli
