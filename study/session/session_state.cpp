#include "study/session/session_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/check.h"
#include "oc_core/base/sha256.h"
#include "study/session/frame_timing.h"
#include "study/session/session_pages.h"
#include "study/session/utc_time.h"

namespace ocelli {
namespace {

/// Whether trials are to have it, and so their logs.
bool isForTrials(const InputEvent& event) {
  if (const auto* move = std::get_if<PointerMoveEvent>(&event)) {
    return std::isfinite(move->x) && std::isfinite(move->y);
  }
  return std::holds_alternative<KeyEvent>(event) || std::holds_alternative<PointerButtonEvent>(event) ||
         std::holds_alternative<ScrollEvent>(event);
}

std::string joined(const std::vector<std::string>& paragraphs) {
  std::string text;
  for (const std::string& paragraph : paragraphs) {
    text += (text.empty() ? "" : "\n\n") + paragraph;
  }
  return text;
}

}  // namespace

SessionFlow::State::State(const Protocol& theProtocol, SessionSchedule theSchedule, const SessionDone& done,
                          SessionFlowOptions theOptions, SessionSink& theSink)
    : protocol(theProtocol),
      schedule(std::move(theSchedule)),
      options(std::move(theOptions)),
      sink(theSink),
      attempts(done.attempts),
      agenda(agendaOf(theProtocol, schedule, done)),
      practiceBegun(done.practiceBegun) {
  attempts.resize(schedule.trials.size(), 0);
  const std::vector<int> kept = keptTrials(protocol, schedule, done);
  completed.insert(kept.begin(), kept.end());
  answered = done.answered;
  std::erase_if(answered, [&](const auto& each) { return !completed.contains(each.first); });
  if (!options.utcNow) {
    options.utcNow = utcNow;
  }
  tryTrials(protocol, schedule, options.screen);
  enterStep();
}

void SessionFlow::State::event(const std::string& what, const std::string& detail) {
  if (storesEvents()) {
    sink.event({now, options.utcNow(), what, detail});
  }
}

void SessionFlow::State::end(SessionEnding how, const std::string& title, const std::vector<std::string>& paragraphs) {
  if (!ending || how == SessionEnding::kFailed) {
    ending = how;
    sink.sessionEnds(how, options.utcNow());
  }
  closingPage = lastPage(protocol.texts, title, paragraphs);
}

void SessionFlow::State::checkSink() {
  const std::optional<std::string> why = sink.failure();
  if (why && ending != SessionEnding::kFailed) {
    failure = *why;
    trial.reset();
    end(SessionEnding::kFailed, say("stopped"), {say("stopped_storing"), say("call_experimenter"), *why});
  }
}

void SessionFlow::State::nextStep() {
  agenda.pop_front();
  enterStep();
}

void SessionFlow::State::enterStep() {
  OC_CHECK(!agenda.empty(), "a session ends with its last step");
  form.reset();
  if (const auto* formStep = current<FormStep>()) {
    form.emplace(*formStep->form, protocol.texts.rightToLeft());
  } else if (const auto* text = current<TextStep>()) {
    event("page", text->page->title);
  } else if (auto* step = current<BreakStep>()) {
    // A trial that was done again during the break does not make it longer.
    if (!step->began) {
      step->began = true;
      breakBegan = now;
      event("break", "begins");
    }
  } else if (const auto* practiceStep = current<PracticeStep>()) {
    goOnWithPractice(*practiceStep);
  } else if (current<EndStep>() != nullptr) {
    end(SessionEnding::kCompleted, say("thanks"), {say("thanks_all"), say("call_experimenter")});
  }
}

void SessionFlow::State::goOnWithPractice(const PracticeStep& step) {
  const auto [block, round] = step;
  const ProtocolPractice& rules = *blockOf(block).practice;
  const Practice& so = practice[{block, round}];
  if (so.inARow >= rules.minCorrect) {
    // Whoever resumes a session asks for the last round alone.
    event(isLastRound(block) ? "practice_passed" : "practice_view_passed", std::to_string(block));
    nextStep();
  } else if (so.trials >= rules.maxTrials) {
    event("practice_failed", std::to_string(block));
    agenda.front() = CallStep{block, round};
  } else {
    agenda.push_front(TrialStep{practiceTrial(schedule, protocol, block, so.trials, round)});
  }
}

void SessionFlow::State::continueAfterPractice() {
  const int block = current<CallStep>()->block;
  event(isLastRound(block) ? "practice_continued" : "practice_view_continued", std::to_string(block));
  nextStep();
}

bool SessionFlow::State::isLastRound(int block) const {
  const PracticeStep* next = agenda.size() > 1 ? std::get_if<PracticeStep>(&agenda[1]) : nullptr;
  return next == nullptr || next->block != block;
}

void SessionFlow::State::decline() {
  sink.consent(consentRecord(false));
  end(SessionEnding::kDeclined, say("thanks"), {say("declined"), say("call_experimenter")});
}

ConsentRecord SessionFlow::State::consentRecord(bool agreed) const {
  const std::string text = joined(protocol.consent->paragraphs);
  return {protocol.consent->title, text, sha256(text), agreed, options.utcNow()};
}

void SessionFlow::State::goOn() {
  if (closingPage) {
    closed = true;
  } else if (current<ConsentStep>() != nullptr) {
    sink.consent(consentRecord(true));
    nextStep();
  } else if (form) {
    if (form->goOn()) {
      storeForm();
    }
  } else if (current<CallStep>() != nullptr) {
    if (options.kind != SubjectKind::kPerson) {
      continueAfterPractice();  // they have no experimenter
    }
  } else if (auto* step = current<TrialStep>()) {
    if (!step->ready) {
      step->ready = true;
      step->plan = shownPlan(protocol, step->plan, answered);
      beginTrial(step->plan);
    }
  } else if (current<BreakStep>() != nullptr) {
    if (breakSecondsLeft() <= 0) {
      event("break", "ends");
      nextStep();
    }
  } else {
    nextStep();
  }
}

double SessionFlow::State::breakSecondsLeft() const {
  return std::max(0.0, protocol.breakSeconds - static_cast<double>(now - breakBegan) * 1e-9);
}

void SessionFlow::State::storeForm() {
  const FormScreen& of = form->screen();
  for (size_t i = 0; i < of.items.size(); ++i) {
    sink.answer({of.form->name, of.items[i].name, form->answer(i), options.utcNow()});
  }
  nextStep();
}

void SessionFlow::State::beginTrial(const TrialPlan& plan) {
  const TaskBlock& task = taskOf(plan);
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

void SessionFlow::State::endTrial(TrialEnding how) {
  trial->handOver();
  record.ending = how;
  record.endedNanoseconds = now;
  record.endedUtc = options.utcNow();
  const std::vector<int64_t>& shown = trial->shownNanoseconds();
  record.startedNanoseconds = shown.empty() ? record.startedNanoseconds : shown.front();
  record.timing =
      timingOf(shown, protocol.timing, {options.intervalNanoseconds, options.unstableRefresh, options.simulatedClock});
  if (how == TrialEnding::kCompleted) {
    record.outcome = *trial->run().outcome();
  }
  sink.trialEnds(trial->number(), record);
  if (record.timing.verdict == TimingVerdict::kDroppedFrames) {
    event("late_frames", fmt::format("{} of {} frames of the trial", record.timing.dropped, record.timing.frames));
  } else if (record.timing.verdict == TimingVerdict::kEarlyFrames) {
    event("early_frames",
          fmt::format("every {:.2f} ms of {:.2f}", static_cast<double>(record.timing.medianNanoseconds) / 1e6,
                      static_cast<double>(options.intervalNanoseconds) / 1e6));
  }
  lastTiming = record.timing;
  lastPlan = record.plan;
  trial.reset();
  trialWasOnScreen = false;
  std::get<TrialStep>(agenda.front()).ready = false;
}

void SessionFlow::State::completeTrial() {
  endTrial(TrialEnding::kCompleted);
  const TrialPlan plan = record.plan;
  bool feedback = blockOf(plan.block).feedback;
  if (plan.practice) {
    feedback = true;
    Practice& so = practiceOf(plan);
    ++so.trials;
    so.inARowBefore = so.inARow;
    so.inARow = record.outcome.correct ? so.inARow + 1 : 0;
  } else {
    completed.insert(plan.index);
    answerStaircase(plan);
  }
  if (feedback) {
    agenda.front() = FeedbackStep{record.outcome};
    enterStep();
  } else {
    nextStep();
  }
}

void SessionFlow::State::answerStaircase(const TrialPlan& plan) {
  const ProtocolBlock& block = blockOf(plan.block);
  if (!block.staircase) {
    return;
  }
  answered[plan.index] = {plan.block, plan.view, plan.caseIndex, record.outcome.correct};
  const StaircaseState state = staircaseState(protocol, plan.block, plan.view, answered);
  if (state.trials == block.staircase->trials) {
    event("staircase", fmt::format("{}, {}: {} after {} trials", block.name, protocol.nameOf(plan.view),
                                   thresholdText(state), state.trials));
  }
}

void SessionFlow::State::interruptTrial(TrialEnding how) {
  if (trial) {
    endTrial(how);
  }
}

void SessionFlow::State::press(Key key, bool isRepeat) {
  const bool isEnter = key == Key::kEnter && !isRepeat;
  if (closingPage) {
    if (isEnter) {
      goOn();
    }
  } else if (asksUnwell) {
    if (isEnter || (key == Key::kEscape && !isRepeat)) {
      answerUnwell(isEnter);
    }
  } else if (key == Key::kF10) {
    interruptTrial(TrialEnding::kAborted);
    event("unwell", "asks");
    asksUnwell = true;
  } else if (pauseReason) {
    return;
  } else if (form) {
    // Arrows may repeat; what switches something does not.
    if ((!isRepeat || (key != Key::kEnter && key != Key::kSpace)) && form->press(key)) {
      storeForm();
    }
  } else if (isEnter) {
    goOn();
  } else if (key == Key::kF12 && !isRepeat && current<CallStep>() != nullptr) {
    continueAfterPractice();
  } else if (key == Key::kEscape && !isRepeat && current<ConsentStep>() != nullptr) {
    decline();
  }
}

void SessionFlow::State::type(char32_t character) {
  if (form && !closingPage && !asksUnwell && !pauseReason) {
    form->type(character);
  }
}

void SessionFlow::State::answerUnwell(bool ends) {
  asksUnwell = false;
  event("unwell", ends ? "ends the session" : "goes on");
  if (ends) {
    end(SessionEnding::kUnwell, say("ended"), {say("ended_rest")});
  }
}

bool SessionFlow::State::take(const TimedInput& input) {
  const auto* key = std::get_if<KeyEvent>(&input.event);
  const bool isUnwell = key != nullptr && key->pressed && key->key == Key::kF10;
  const bool toTrial = trial && !isUnwell && isForTrials(input.event);
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
  if (const auto* text = std::get_if<TextEvent>(&input.event)) {
    type(text->character);
  }
  if (trial && trial->isOver()) {
    completeTrial();
  }
  return true;
}

void SessionFlow::State::update(int64_t time) {
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

}  // namespace ocelli
