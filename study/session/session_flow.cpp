#include "study/session/session_flow.h"

#include "study/session/session_state.h"

namespace ocelli {

void tryTrials(const Protocol& protocol, const SessionSchedule& schedule, const TrialScreen& screen) {
  std::set<std::pair<int, TrialView>> tried;
  for (const TrialPlan& plan : schedule.trials) {
    if (!tried.insert({plan.block, plan.view}).second) {
      continue;
    }
    const ProtocolBlock& block = protocol.blocks[static_cast<size_t>(plan.block)];
    block.task->start(plan, screen);
    if (block.practice) {
      TrialPlan first = practiceTrial(schedule, protocol, plan.block, 0);
      first.view = plan.view;
      block.practice->task->start(first, screen);
    }
  }
}

SessionFlow::SessionFlow(const Protocol& protocol, const SessionSchedule& schedule, const SessionDone& done,
                         const SessionFlowOptions& options, SessionSink& sink)
    : state_(std::make_unique<State>(protocol, schedule, done, options, sink)) {}

SessionFlow::~SessionFlow() = default;

void SessionFlow::handle(const TimedInput& input) {
  state_->inputs.push_back(input);
}

void SessionFlow::act(const FormAction& action, int64_t nanoseconds) {
  State& state = *state_;
  state.update(nanoseconds);
  if (state.asksUnwell && !state.closingPage) {
    if (action.kind != FormAction::Kind::kClick) {
      state.answerUnwell(action.kind == FormAction::Kind::kGoOn);
    }
    return;
  }
  if (state.closed || (state.pauseReason && !state.closingPage)) {
    return;
  }
  switch (action.kind) {
    case FormAction::Kind::kClick:
      if (state.form) {
        state.form->click(action.item, action.click);
      }
      break;
    case FormAction::Kind::kGoOn:
      state.goOn();
      break;
    case FormAction::Kind::kDecline:
      if (state.current<ConsentStep>() != nullptr && !state.closingPage) {
        state.decline();
      }
      break;
  }
}

void SessionFlow::gaze(std::span<const GazeRecord> samples) {
  if (state_->trial) {
    state_->trial->takeGaze(samples);
  }
}

void SessionFlow::update(int64_t nanoseconds) {
  state_->update(nanoseconds);
}

void SessionFlow::frameShown(int64_t nanoseconds, std::optional<uint64_t> pixelHash) {
  if (state_->trial && state_->trialWasOnScreen) {
    state_->trial->frameShown(nanoseconds, pixelHash);
  }
}

SessionScreen SessionFlow::screen() const {
  return state_->screen();
}

bool SessionFlow::isOver() const {
  return state_->closed;
}

SessionEnding SessionFlow::ending() const {
  return state_->ending.value_or(SessionEnding::kAborted);
}

SessionStatus SessionFlow::status() const {
  const State& state = *state_;
  SessionStatus status;
  status.step = state.closingPage ? std::string("ended: ").append(nameOf(ending()))
                : state.asksUnwell
                    ? "feels unwell"
                    : std::visit([&](const auto& step) { return state.nameOf(step); }, state.agenda.front());
  status.blindStep = state.closingPage || state.asksUnwell
                         ? status.step
                         : std::visit([&](const auto& step) { return state.blindNameOf(step); }, state.agenda.front());
  status.progress = state.progress();
  status.paused = state.pauseReason.has_value();
  status.lastTiming = state.lastTiming;
  status.wantsExperimenter =
      state.asksUnwell || state.closingPage.has_value() || std::holds_alternative<CallStep>(state.agenda.front());
  status.ended = state.closingPage.has_value();
  status.failure = state.failure;
  return status;
}

const TrialRun* SessionFlow::trial() const {
  return state_->trial ? &state_->trial->run() : nullptr;
}

std::optional<TrialPlan> SessionFlow::trialPlan() const {
  return state_->trial ? std::optional(state_->record.plan) : std::nullopt;
}

void SessionFlow::pause(const std::string& reason) {
  State& state = *state_;
  if (state.ending || state.pauseReason) {
    return;
  }
  state.interruptTrial(TrialEnding::kAborted);
  state.event("pause", reason);
  state.pauseReason = reason;
}

void SessionFlow::resume() {
  State& state = *state_;
  if (state.pauseReason && !state.ending) {
    state.event("resume");
    state.pauseReason.reset();
  } else if (state.current<CallStep>() != nullptr && !state.ending) {
    state.continueAfterPractice();
  }
}

bool SessionFlow::redo() {
  State& state = *state_;
  if (state.ending || (!state.trial && !state.lastPlan)) {
    return false;
  }
  if (state.trial) {
    state.interruptTrial(TrialEnding::kRedone);
    state.event("redo", state.nameOfTrial(*state.lastPlan, SubjectTexts()));
  } else {
    const TrialPlan plan = *state.lastPlan;
    if (const auto* step = state.current<TrialStep>(); step != nullptr && step->plan == plan) {
      return true;  // it comes again anyway
    }
    if (plan.practice && state.practiceOf(plan).trials > 0) {
      State::Practice& practice = state.practiceOf(plan);
      --practice.trials;
      practice.inARow = practice.inARowBefore;
    }
    state.event("redo", state.nameOfTrial(plan, SubjectTexts()));
    if (state.current<FeedbackStep>() != nullptr) {
      state.agenda.pop_front();  // it was of that trial
    } else if (state.current<CallStep>() != nullptr) {
      state.agenda.front() = PracticeStep{plan.block, state.roundOf(plan)};
    }
    state.agenda.push_front(TrialStep{plan});
    state.form.reset();
  }
  return true;
}

void SessionFlow::abort(const std::string& reason) {
  State& state = *state_;
  if (state.closingPage) {
    state.closed = true;
    return;
  }
  state.interruptTrial(TrialEnding::kAborted);
  state.event("abort", reason);
  state.end(SessionEnding::kAborted, state.say("ended"), {state.say("ended_by_experimenter")});
}

bool SessionFlow::note(const std::string& text) {
  state_->event("note", text);
  return state_->storesEvents();
}

void SessionFlow::report(const std::string& what, const std::string& detail) {
  state_->event(what, detail);
}

}  // namespace ocelli
