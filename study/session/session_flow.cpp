#include "study/session/session_flow.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <map>
#include <set>

#include "oc_core/base/check.h"
#include "oc_core/base/sha256.h"
#include "study/session/form_answers.h"
#include "study/session/frame_timing.h"
#include "study/session/running_trial.h"
#include "study/session/session_agenda.h"
#include "study/session/session_pages.h"
#include "study/session/utc_time.h"

namespace ocelli {
namespace {

constexpr int64_t kNanosecondsPerSecond = 1'000'000'000;

std::string joined(const std::vector<std::string>& paragraphs) {
  std::string text;
  for (const std::string& paragraph : paragraphs) {
    text += (text.empty() ? "" : "\n\n") + paragraph;
  }
  return text;
}

}  // namespace

struct SessionFlow::State {
  State(const Protocol& theProtocol, SessionSchedule theSchedule, const SessionDone& done,
        SessionFlowOptions theOptions, SessionSink& theSink)
      : protocol(theProtocol),
        schedule(std::move(theSchedule)),
        options(std::move(theOptions)),
        sink(theSink),
        attempts(done.attempts),
        agenda(agendaOf(theProtocol, schedule, done)) {
    attempts.resize(schedule.trials.size(), 0);
    const std::vector<int> kept = keptTrials(protocol, schedule, done);
    completed.insert(kept.begin(), kept.end());
    if (!options.utcNow) {
      options.utcNow = utcNow;
    }
    enterStep();
  }

  const Protocol& protocol;
  SessionSchedule schedule;
  SessionFlowOptions options;
  SessionSink& sink;
  std::vector<int> attempts;  ///< of each plan, how often it began
  std::set<int> completed{};  ///< indices of plans
  int64_t now = 0;

  std::deque<TimedInput> inputs{};  ///< that came, and took no effect yet
  std::set<Key> held{};

  // The first step is the one under way.
  std::deque<SessionStep> agenda;
  std::optional<FormAnswers> form{};
  int64_t breakBegan = 0;
  struct Practice {
    int trials = 0;
    int inARow = 0;
    int inARowBefore = 0;  ///< the last trial
  };
  std::map<int, Practice> practice{};  ///< of blocks
  std::unique_ptr<RunningTrial> trial{};
  TrialRecord record{};  ///< of the trial that runs
  bool trialWasOnScreen = false;
  int trialsBegun = 0;
  std::vector<TrialPlan> practiceBegun{};
  std::optional<TrialPlan> lastPlan{};
  TrialTiming lastTiming{};

  // What is shown before the step under way.
  std::optional<std::string> pauseReason{};
  bool asksUnwell = false;
  std::optional<PageScreen> closingPage{};  ///< of a session that has ended, or failed
  std::optional<SessionEnding> ending{};
  bool closed = false;

  template <class Step>
  Step* current() {
    return agenda.empty() ? nullptr : std::get_if<Step>(&agenda.front());
  }
  const ProtocolBlock& blockOf(int index) const { return protocol.blocks[static_cast<size_t>(index)]; }

  // ---- Records

  void event(const std::string& what, const std::string& detail = {}) {
    if (!ending) {
      sink.event({now, options.utcNow(), what, detail});
    }
  }
  void end(SessionEnding how, const std::string& title, const std::vector<std::string>& paragraphs) {
    if (!ending || how == SessionEnding::kFailed) {
      ending = how;
      sink.sessionEnds(how, options.utcNow());
    }
    closingPage = lastPage(title, paragraphs);
  }
  void checkSink() {
    const std::optional<std::string> failure = sink.failure();
    if (failure && ending != SessionEnding::kFailed) {
      trial.reset();
      end(SessionEnding::kFailed, "The session has stopped",
          {"Nothing more can be stored. What was stored before is safe.", "Please call the experimenter.", *failure});
    }
  }

  // ---- Steps

  void nextStep() {
    agenda.pop_front();
    enterStep();
  }
  /// What happens when a step comes under way. Steps that show nothing are done at once.
  void enterStep() {
    OC_CHECK(!agenda.empty(), "a session ends with its last step");
    form.reset();
    if (const auto* step = current<FormStep>()) {
      form.emplace(*step->form);
    } else if (const auto* text = current<TextStep>()) {
      event("page", text->page->title);
    } else if (current<BreakStep>() != nullptr) {
      breakBegan = now;
      event("break", "begins");
    } else if (const auto* practiceStep = current<PracticeStep>()) {
      goOnWithPractice(practiceStep->block);
    } else if (current<EndStep>() != nullptr) {
      end(SessionEnding::kCompleted, "Thank you", {"This was all for today.", "Please call the experimenter."});
    }
  }

  void goOnWithPractice(int block) {
    const ProtocolPractice& rules = *blockOf(block).practice;
    const Practice& so = practice[block];
    if (so.inARow >= rules.leastCorrect) {
      event("practice_passed", std::to_string(block));
      nextStep();
    } else if (so.trials >= rules.mostTrials) {
      event("practice_failed", std::to_string(block));
      agenda.front() = CallStep{block};
    } else {
      agenda.push_front(TrialStep{practiceTrial(schedule, protocol, block, so.trials)});
    }
  }

  void decline() {
    sink.consent(consentRecord(false));
    end(SessionEnding::kDeclined, "Thank you",
        {"You do not take part. Nothing more is stored.", "Please call the experimenter."});
  }
  ConsentRecord consentRecord(bool agreed) const {
    const std::string text = joined(protocol.consent->paragraphs);
    return {protocol.consent->title, text, sha256(text), agreed, options.utcNow()};
  }

  /// Enter, or the button to go on.
  void goOn() {
    if (closingPage) {
      closed = true;
    } else if (current<ConsentStep>() != nullptr) {
      sink.consent(consentRecord(true));
      nextStep();
    } else if (form) {
      if (form->goOn()) {
        storeForm();
      }
    } else if (const auto* call = current<CallStep>()) {
      event("practice_continued", std::to_string(call->block));
      nextStep();
    } else if (auto* step = current<TrialStep>()) {
      if (!step->ready) {
        step->ready = true;
        beginTrial(step->plan);
      }
    } else if (current<BreakStep>() != nullptr) {
      if (breakLeft() <= 0) {
        event("break", "ends");
        nextStep();
      }
    } else {
      nextStep();
    }
  }
  void storeForm() {
    const ProtocolForm& of = *form->screen().form;
    for (size_t i = 0; i < of.fields.size(); ++i) {
      sink.answer({of.name, of.fields[i].name, form->answer(i), options.utcNow()});
    }
    nextStep();
  }
  int64_t breakLeft() const { return breakBegan + protocol.breakSeconds * kNanosecondsPerSecond - now; }

  // ---- Trials

  void beginTrial(const TrialPlan& plan) {
    const ProtocolBlock& block = blockOf(plan.block);
    const TaskBlock& task = plan.practice ? *block.practice->task : *block.task;
    std::unique_ptr<TrialRun> run = task.start(plan, options.screen);
    if (plan.practice) {
      practiceBegun.push_back(plan);
    }
    const auto attempt = static_cast<int>(plan.practice ? std::count(practiceBegun.begin(), practiceBegun.end(), plan)
                                                        : ++attempts[static_cast<size_t>(plan.index)]);
    record = {};
    record.plan = plan;
    record.attempt = attempt;
    record.info = task.caseInfo(plan.caseIndex);
    record.screen = options.screen;
    record.startedUtc = options.utcNow();
    record.startedNanoseconds = now;
    trial = std::make_unique<RunningTrial>(std::move(run), trialsBegun++, sink);
    sink.trialBegins(trial->number(), plan, attempt);
  }

  /// The trial that runs, in whichever way. Its step is still the first.
  void endTrial(TrialEnding how) {
    trial->handOver();
    record.ending = how;
    record.endedNanoseconds = now;
    record.endedUtc = options.utcNow();
    const std::vector<int64_t>& shown = trial->shownNanoseconds();
    record.startedNanoseconds = shown.empty() ? record.startedNanoseconds : shown.front();
    record.timing = timingOf(shown, protocol.timing,
                             {options.intervalNanoseconds, options.unstableRefresh, options.simulatedClock});
    if (how == TrialEnding::kCompleted) {
      record.outcome = *trial->run().outcome();
    }
    sink.trialEnds(trial->number(), record);
    if (record.timing.verdict == "dropped_frames") {
      event("late_frames", fmt::format("{} of {} frames of the trial", record.timing.dropped, record.timing.frames));
    }
    lastTiming = record.timing;
    lastPlan = record.plan;
    trial.reset();
    trialWasOnScreen = false;
    std::get<TrialStep>(agenda.front()).ready = false;
  }

  void completeTrial() {
    endTrial(TrialEnding::kCompleted);
    const TrialPlan plan = record.plan;
    bool feedback = blockOf(plan.block).feedback;
    if (plan.practice) {
      feedback = true;
      Practice& so = practice[plan.block];
      ++so.trials;
      so.inARowBefore = so.inARow;
      so.inARow = record.outcome.correct ? so.inARow + 1 : 0;
    } else {
      completed.insert(plan.index);
    }
    if (feedback) {
      agenda.front() = FeedbackStep{record.outcome};
      enterStep();
    } else {
      nextStep();
    }
  }

  /// Something stops the trial; it comes again.
  void interruptTrial(TrialEnding how) {
    if (trial) {
      endTrial(how);
    }
  }

  // ---- Input

  void press(Key key, bool isRepeat) {
    const bool isEnter = key == Key::kEnter && !isRepeat;
    if (closingPage) {
      if (isEnter) {
        goOn();
      }
    } else if (asksUnwell) {
      if (isEnter) {
        asksUnwell = false;
        event("unwell", "ends the session");
        end(SessionEnding::kUnwell, "The session has ended", {"Please rest, and tell the experimenter."});
      } else if (key == Key::kEscape && !isRepeat) {
        asksUnwell = false;
        event("unwell", "goes on");
      }
    } else if (key == Key::kF10) {
      interruptTrial(TrialEnding::kAborted);
      event("unwell", "asks");
      asksUnwell = true;
    } else if (pauseReason) {
      return;
    } else if (form) {
      // Arrows may repeat.
      if ((!isRepeat || key != Key::kEnter) && form->press(key)) {
        storeForm();
      }
    } else if (isEnter) {
      goOn();
    } else if (key == Key::kEscape && !isRepeat && current<ConsentStep>() != nullptr) {
      decline();
    }
  }

  /// Returns whether the input was taken; else its time is yet to come.
  bool take(const TimedInput& input) {
    const auto* key = std::get_if<KeyEvent>(&input.event);
    const bool toTrial = trial && !(key != nullptr && key->pressed && key->key == Key::kF10);
    if (toTrial && !trial->take(input, now)) {
      if (!trial->isOver()) {
        return false;
      }
      completeTrial();
      return take(input);
    }
    if (key != nullptr) {
      const bool isRepeat = key->pressed && held.contains(key->key);
      if (key->pressed) {
        held.insert(key->key);
      } else {
        held.erase(key->key);
      }
      if (!toTrial && key->pressed) {
        press(key->key, isRepeat);
      }
    }
    if (trial && trial->isOver()) {
      completeTrial();
    }
    return true;
  }

  void update(int64_t time) {
    now = std::max(now, time);
    if (!closed) {
      checkSink();
    }
    while (!closed && !inputs.empty() && inputs.front().nanoseconds <= now && take(inputs.front())) {
      inputs.pop_front();
    }
    if (trial) {
      trial->update(now);
      if (trial->isOver()) {
        completeTrial();
      }
    }
    trialWasOnScreen = trial != nullptr && !pauseReason && !asksUnwell;
  }

  // ---- What is shown

  SessionProgress progress() const {
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

  std::string nameOfTrial(const TrialPlan& plan) const {
    return plan.practice ? "Practice" : fmt::format("Trial {} of {}", plan.index + 1, schedule.trials.size());
  }

  SessionScreen screenOf(const ConsentStep&) const { return ConsentScreen{*protocol.consent}; }
  SessionScreen screenOf(const FormStep&) const { return form->screen(); }
  SessionScreen screenOf(const TextStep& step) const { return pageOf(*step.page); }
  SessionScreen screenOf(const PracticeStep&) const { return PageScreen{}; }
  SessionScreen screenOf(const CallStep&) const { return callPage(); }
  SessionScreen screenOf(const TrialStep& step) const {
    if (trial) {
      return TrialScreenView{trial->run().picture(), trial->nextFrame() % 2 == 0, protocol.screen.photodiodePatch};
    }
    return readyPage(nameOfTrial(step.plan), blockOf(step.plan.block).title, progress());
  }
  SessionScreen screenOf(const FeedbackStep& step) const { return feedbackPage(step.outcome); }
  SessionScreen screenOf(const BreakStep&) const {
    return breakPage(progress(), static_cast<double>(std::max<int64_t>(breakLeft(), 0)) /
                                     static_cast<double>(kNanosecondsPerSecond));
  }
  SessionScreen screenOf(const EndStep&) const { return PageScreen{}; }

  SessionScreen screen() const {
    if (closingPage) {
      return *closingPage;
    }
    if (asksUnwell) {
      return unwellPage();
    }
    if (pauseReason) {
      return PauseScreen{*pauseReason};
    }
    return std::visit([&](const auto& step) { return screenOf(step); }, agenda.front());
  }

  std::string nameOf(const ConsentStep&) const { return "consent"; }
  std::string nameOf(const FormStep& step) const { return "form " + step.form->name; }
  std::string nameOf(const TextStep& step) const { return "page " + step.page->title; }
  std::string nameOf(const PracticeStep&) const { return "practice"; }
  std::string nameOf(const CallStep&) const { return "practice failed"; }
  std::string nameOf(const TrialStep& step) const {
    const TrialPlan& plan = step.plan;
    const ProtocolBlock& block = blockOf(plan.block);
    const TaskBlock& task = plan.practice ? *block.practice->task : *block.task;
    return fmt::format(
        "{}{}, {}, {}, {}", trial ? "" : "before ",
        plan.practice ? "practice" : fmt::format("trial {} of {}", plan.index + 1, schedule.trials.size()), block.name,
        ocelli::nameOf(plan.view), task.caseInfo(plan.caseIndex).label);
  }
  std::string nameOf(const FeedbackStep&) const { return "feedback"; }
  std::string nameOf(const BreakStep&) const { return "break"; }
  std::string nameOf(const EndStep&) const { return "end"; }
};

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
  if (state.closed || state.asksUnwell || (state.pauseReason && !state.closingPage)) {
    return;
  }
  switch (action.kind) {
    case FormAction::Kind::kChoose:
      if (state.form) {
        state.form->choose(action.field, action.option);
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
  status.progress = state.progress();
  status.paused = state.pauseReason.has_value();
  status.lastTiming = state.lastTiming;
  status.wantsExperimenter =
      state.asksUnwell || state.closingPage.has_value() || std::holds_alternative<CallStep>(state.agenda.front());
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
  }
}

void SessionFlow::redo() {
  State& state = *state_;
  if (state.ending) {
    return;
  }
  if (state.trial) {
    state.interruptTrial(TrialEnding::kRedone);
    state.event("redo", state.nameOfTrial(*state.lastPlan));
  } else if (state.lastPlan) {
    const TrialPlan plan = *state.lastPlan;
    if (const auto* step = state.current<TrialStep>(); step != nullptr && step->plan == plan) {
      return;  // it comes again anyway
    }
    State::Practice& practice = state.practice[plan.block];
    if (plan.practice && practice.trials > 0) {
      --practice.trials;
      practice.inARow = practice.inARowBefore;
    }
    state.event("redo", state.nameOfTrial(plan));
    if (state.current<FeedbackStep>() != nullptr) {
      state.agenda.pop_front();  // it was of that trial
    } else if (state.current<CallStep>() != nullptr) {
      state.agenda.front() = PracticeStep{plan.block};
    }
    state.agenda.push_front(TrialStep{plan});
    state.form.reset();
  }
}

void SessionFlow::abort(const std::string& reason) {
  State& state = *state_;
  if (state.closingPage) {
    state.closed = true;
    return;
  }
  state.interruptTrial(TrialEnding::kAborted);
  state.event("abort", reason);
  state.end(SessionEnding::kAborted, "The session has ended", {"The experimenter has ended the session."});
}

void SessionFlow::note(const std::string& text) {
  state_->event("note", text);
}

void SessionFlow::report(const std::string& what, const std::string& detail) {
  state_->event(what, detail);
}

}  // namespace ocelli
