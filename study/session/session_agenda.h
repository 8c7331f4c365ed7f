// What is left to do in a session, step by step.
#pragma once

#include <deque>
#include <optional>
#include <variant>

#include "study/session/session_flow.h"

namespace ocelli {

struct ConsentStep {};
struct FormStep {
  const ProtocolForm* form = nullptr;
};
/// A page of the protocol.
struct TextStep {
  const ProtocolPage* page = nullptr;
};
/// Decides whether another practice trial of the block comes, of a round of its practice (practiceRounds()).
struct PracticeStep {
  int block = 0;                     ///< in the protocol
  std::optional<TrialView> round{};  ///< its view
};
/// Practice did not succeed: the experimenter is asked for.
struct CallStep {
  int block = 0;
  std::optional<TrialView> round{};
};
/// A page before the trial, for subjects to begin when they are ready; then the trial.
struct TrialStep {
  TrialPlan plan;
  bool ready = false;  ///< the page was left
};
struct FeedbackStep {
  TrialOutcome outcome;
};
struct BreakStep {
  bool began = false;
};
struct EndStep {};

using SessionStep =
    std::variant<ConsentStep, FormStep, TextStep, PracticeStep, CallStep, TrialStep, FeedbackStep, BreakStep, EndStep>;

/// Throws InputError where something was done and the protocol does not allow to resume.
std::deque<SessionStep> agendaOf(const Protocol& protocol, const SessionSchedule& schedule, const SessionDone& done);

/// Indices of plans that need not be done again.
std::vector<int> keptTrials(const Protocol& protocol, const SessionSchedule& schedule, const SessionDone& done);

}  // namespace ocelli
