#include "study/session/session_agenda.h"

#include <algorithm>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

bool contains(const std::vector<int>& list, int element) {
  return std::find(list.begin(), list.end(), element) != list.end();
}

void addForm(std::deque<SessionStep>& agenda, const ProtocolForm& form, const SessionDone& done) {
  if (std::find(done.forms.begin(), done.forms.end(), form.name) == done.forms.end()) {
    agenda.push_back(FormStep{&form});
  }
}

void addForms(std::deque<SessionStep>& agenda, const std::vector<ProtocolForm>& forms, const SessionDone& done) {
  for (const ProtocolForm& form : forms) {
    addForm(agenda, form, done);
  }
}

std::vector<TrialPlan> trialsOf(const SessionSchedule& schedule, int block) {
  std::vector<TrialPlan> trials;
  std::copy_if(schedule.trials.begin(), schedule.trials.end(), std::back_inserter(trials),
               [&](const TrialPlan& plan) { return plan.block == block; });
  return trials;
}

}  // namespace

std::vector<int> keptTrials(const Protocol& protocol, const SessionSchedule& schedule, const SessionDone& done) {
  std::vector<int> kept;
  for (const int block : schedule.blockOrder) {
    const std::vector<TrialPlan> trials = trialsOf(schedule, block);
    const auto isDone = [&](const TrialPlan& plan) { return contains(done.completedTrials, plan.index); };
    if (protocol.resume == ResumePolicy::kRestartBlock && !std::all_of(trials.begin(), trials.end(), isDone)) {
      continue;
    }
    for (const TrialPlan& plan : trials) {
      if (isDone(plan)) {
        kept.push_back(plan.index);
      }
    }
  }
  return kept;
}

std::deque<SessionStep> agendaOf(const Protocol& protocol, const SessionSchedule& schedule, const SessionDone& done) {
  const bool began = std::any_of(done.attempts.begin(), done.attempts.end(), [](int count) { return count > 0; });
  const bool isResumed = began || !done.completedTrials.empty() || !done.blocksPracticed.empty();
  if (isResumed && protocol.resume == ResumePolicy::kStop) {
    throw InputError("trials of this session were done before, and the protocol does not allow to resume it",
                     "protocol, \"resume\"", "withdraw the subject and begin with another id, or allow it there");
  }
  std::deque<SessionStep> agenda;
  if (protocol.consent && !done.consented) {
    agenda.push_back(ConsentStep{});
  }
  if (schedule.session == 1 && protocol.demographics) {
    addForm(agenda, *protocol.demographics, done);
  }
  addForms(agenda, protocol.before, done);
  if (!isResumed) {
    for (const ProtocolPage& page : protocol.welcome) {
      agenda.push_back(TextStep{&page});
    }
  }
  const std::vector<int> kept = keptTrials(protocol, schedule, done);
  for (size_t b = 0; b < schedule.blockOrder.size(); ++b) {
    const int block = schedule.blockOrder[b];
    const ProtocolBlock& of = protocol.blocks[static_cast<size_t>(block)];
    const std::vector<TrialPlan> trials = trialsOf(schedule, block);
    if (std::all_of(trials.begin(), trials.end(), [&](const TrialPlan& plan) { return contains(kept, plan.index); })) {
      addForms(agenda, of.after, done);
      continue;
    }
    for (const ProtocolPage& page : of.instructions) {
      agenda.push_back(TextStep{&page});
    }
    if (!contains(done.blocksPracticed, block)) {
      for (const std::optional<TrialView> round : practiceRounds(schedule, protocol, block)) {
        agenda.push_back(PracticeStep{block, round});
      }
    }
    for (size_t i = 0; i < trials.size(); ++i) {
      if (contains(kept, trials[i].index)) {
        continue;
      }
      agenda.push_back(TrialStep{trials[i]});
      const bool isLast = i + 1 == trials.size();
      if (isLast) {
        addForms(agenda, of.after, done);
      }
      if (isLast ? of.breakAfter && b + 1 < schedule.blockOrder.size()
                 : of.breakEveryTrials > 0 && (static_cast<int>(i) + 1) % of.breakEveryTrials == 0) {
        agenda.push_back(BreakStep{});
      }
    }
  }
  addForms(agenda, protocol.after, done);
  if (protocol.survey && (!protocol.surveyAfterLastSessionOnly || schedule.session == protocol.sessions)) {
    addForm(agenda, *protocol.survey, done);
  }
  agenda.push_back(EndStep{});
  return agenda;
}

}  // namespace ocelli
