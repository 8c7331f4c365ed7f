// What a session shows, and how it names it.
#include <fmt/format.h>

#include <algorithm>

#include "study/session/session_state.h"

namespace ocelli {

SessionProgress SessionFlow::State::progress() const {
  SessionProgress so;
  so.trialsDone = static_cast<int>(completed.size());
  so.trials = static_cast<int>(schedule.trials.size());
  so.blocks = static_cast<int>(schedule.blockOrder.size());
  // Of the first trial that is yet to be done.
  const auto open = std::find_if(schedule.trials.begin(), schedule.trials.end(),
                                 [&](const TrialPlan& plan) { return !completed.contains(plan.index); });
  const auto place = open == schedule.trials.end()
                         ? schedule.blockOrder.end()
                         : std::find(schedule.blockOrder.begin(), schedule.blockOrder.end(), open->block);
  so.block = std::min(static_cast<int>(place - schedule.blockOrder.begin()), std::max(so.blocks - 1, 0));
  return so;
}

std::string SessionFlow::State::nameOfTrial(const TrialPlan& plan, const SubjectTexts& texts) const {
  return plan.practice ? texts.say("practice")
                       : texts.say("trial", {{"number", fmt::format("{}", plan.index + 1)},
                                             {"total", fmt::format("{}", schedule.trials.size())}});
}

SessionScreen SessionFlow::State::screenOf(const TrialStep& step) const {
  if (trial) {
    TrialScreenView view{trial->run().layout(), trial->nextFrame() % 2 == 0, protocol.screen.photodiodePatch};
    view.layout.prompt = protocol.texts.translated(view.layout.prompt);
    for (TrialLayout::Choice& choice : view.layout.choices) {
      choice.label = protocol.texts.translated(choice.label);
    }
    return view;
  }
  return readyPage(protocol.texts, nameOfTrial(step.plan, protocol.texts), blockOf(step.plan.block).title, progress());
}

SessionScreen SessionFlow::State::screen() const {
  if (closingPage) {
    return *closingPage;
  }
  if (asksUnwell) {
    return unwellPage(protocol.texts);
  }
  if (pauseReason) {
    return PauseScreen{*pauseReason};
  }
  return std::visit([&](const auto& step) { return screenOf(step); }, agenda.front());
}

std::string SessionFlow::State::blindNameOf(const TrialStep& step) const {
  const TrialPlan& plan = step.plan;
  return fmt::format("{}{}, {}", trial ? "" : "before ",
                     plan.practice ? "practice" : fmt::format("trial {} of {}", plan.index + 1, schedule.trials.size()),
                     blockOf(plan.block).name);
}

std::string SessionFlow::State::nameOf(const TrialStep& step) const {
  const TrialPlan& plan = step.plan;
  const bool isOpen = blockOf(plan.block).staircase && !plan.practice && !trial;  // which case comes
  return fmt::format("{}, {}, {}", blindNameOf(step), protocol.nameOf(plan.view),
                     isOpen ? "staircase" : taskOf(plan).caseInfo(plan.caseIndex).label);
}

}  // namespace ocelli
