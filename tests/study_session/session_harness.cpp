#include "tests/study_session/session_harness.h"

#include <gtest/gtest.h>

#include "study/session/utc_time.h"

namespace ocelli::test {
namespace {

Key digit(int number) {
  return static_cast<Key>(static_cast<int>(Key::k0) + number);
}

class DigitRun : public TrialRun {
 public:
  DigitRun(int right, uint64_t seed) : right_(right) { pose_.x = static_cast<double>(seed % 1000); }

  void handle(const InputEvent& event) override {
    const auto* key = std::get_if<KeyEvent>(&event);
    if (!outcome_ && key != nullptr && key->pressed && key->key >= Key::k1 && key->key <= Key::k9) {
      finish(static_cast<int>(key->key) - static_cast<int>(Key::k0));
    }
  }
  void advance() override {
    if (!outcome_ && ++tick_ >= 2 * kTicksPerSecond) {
      finish(std::nullopt);
    }
  }
  void frameShown(int64_t /*tick*/) override { ++frames_; }
  TrialLayout layout() const override {
    TrialLayout layout;
    layout.prompt = std::to_string(right_);
    return layout;
  }
  WalkerPose pose() const override {
    return {pose_.x + static_cast<double>(tick_) / 7, static_cast<double>(frames_), 0};
  }
  std::optional<TrialOutcome> outcome() const override { return outcome_; }

 private:
  void finish(std::optional<int> answer) {
    TrialOutcome outcome;
    outcome.expected = std::to_string(right_);
    outcome.answer = answer ? std::to_string(*answer) : "";
    outcome.correct = answer == right_;
    outcome.censored = !answer;
    outcome.responseTicks = tick_;
    outcome_ = outcome;
  }

  int right_;
  WalkerPose pose_{};
  int64_t tick_ = 0;
  int64_t frames_ = 0;
  std::optional<TrialOutcome> outcome_{};
};

class DigitBlock : public TaskBlock {
 public:
  explicit DigitBlock(int cases) : cases_(cases) {}
  int caseCount() const override { return cases_; }
  CaseInfo caseInfo(int caseIndex) const override {
    CaseInfo info;
    info.label = "digit " + std::to_string(caseIndex + 1);
    info.longestSeconds = 2;
    info.typicalSeconds = 1;
    return info;
  }
  std::string answerOf(const TrialPlan& plan) const override { return std::to_string(plan.caseIndex + 1); }
  std::unique_ptr<TrialRun> start(const TrialPlan& plan, const TrialScreen&) const override {
    return std::make_unique<DigitRun>(plan.caseIndex + 1, plan.seed);
  }

 private:
  int cases_;
};

}  // namespace

bool FakeSink::hasEvent(const std::string& what) const {
  const std::vector<EventRecord> events = all<EventRecord>();
  return std::any_of(events.begin(), events.end(), [&](const EventRecord& event) { return event.what == what; });
}

std::vector<FrameRecord> FakeSink::framesOf(int number) const {
  std::vector<FrameRecord> records;
  for (const TrialFrames& frames : all<TrialFrames>()) {
    if (frames.number == number) {
      records.insert(records.end(), frames.records.begin(), frames.records.end());
    }
  }
  return records;
}

std::vector<InputRecord> FakeSink::inputsOf(int number) const {
  std::vector<InputRecord> records;
  for (const TrialInputs& inputs : all<TrialInputs>()) {
    if (inputs.number == number) {
      records.insert(records.end(), inputs.records.begin(), inputs.records.end());
    }
  }
  return records;
}

SessionDone doneAfter(std::span<const SinkCall> calls, const SessionSchedule& schedule, const Protocol& protocol) {
  SessionDone done;
  done.attempts.resize(schedule.trials.size());
  std::map<std::string, size_t> answers;
  for (const SinkCall& call : calls) {
    if (const auto* consent = std::get_if<ConsentRecord>(&call)) {
      done.consented = consent->agreed;
    } else if (const auto* answer = std::get_if<AnswerRecord>(&call)) {
      ++answers[answer->form];
    } else if (const auto* begins = std::get_if<TrialBegins>(&call)) {
      if (begins->plan.practice) {
        done.practiceBegun.push_back(begins->plan);
      } else {
        ++done.attempts[static_cast<size_t>(begins->plan.index)];
      }
    } else if (const auto* ends = std::get_if<TrialEnds>(&call)) {
      if (!ends->record.plan.practice && ends->record.ending == TrialEnding::kCompleted) {
        const TrialPlan& plan = ends->record.plan;
        done.completedTrials.push_back(plan.index);
        done.answered[plan.index] = {plan.block, plan.view, plan.caseIndex, ends->record.outcome.correct};
      }
    } else if (const auto* event = std::get_if<EventRecord>(&call)) {
      if (event->what == "practice_passed" || event->what == "practice_continued") {
        done.blocksPracticed.push_back(std::stoi(event->detail));
      }
    }
  }
  for (const ProtocolForm* form : formsOf(protocol)) {
    if (answers[form->name] >= itemsOf(form->fields).size()) {
      done.forms.push_back(form->name);
    }
  }
  return done;
}

std::shared_ptr<const TaskBlock> digitTask(int cases) {
  return std::make_shared<DigitBlock>(cases);
}

Protocol smallProtocol() {
  Protocol protocol;
  protocol.name = "small";
  protocol.text = "{}";
  protocol.title = "A small study";
  protocol.breakSeconds = 2;
  protocol.consent = ProtocolPage{"Consent", {"You may stop at any time.", "Do you take part?"}};
  protocol.demographics = ProtocolForm{"demographics",
                                       "About you",
                                       "",
                                       {{"age_band", "How old are you?", {"18-29", "30-49", "50 or more"}, {}},
                                        {"vision", "How well do you see?", {"well", "with glasses"}, {}}}};
  protocol.welcome = {{"Welcome", {"Thank you for coming."}}};
  ProtocolBlock first;
  first.name = "first";
  first.title = "The first task";
  first.taskName = "digit";
  first.task = digitTask(3);
  first.instructions = {{"First", {"Press the digit."}}, {"Ready?", {"Practice comes first."}}};
  first.practice = ProtocolPractice{digitTask(2), 2, 3};
  first.feedback = true;
  first.breakEveryTrials = 2;
  ProtocolBlock second = first;
  second.name = "second";
  second.task = digitTask(2);
  second.practice.reset();
  second.feedback = false;
  second.breakEveryTrials = 0;
  protocol.blocks = {first, second};
  protocol.survey = ProtocolForm{
      "survey", "At last", "", {{"find", "Which was easier?", {"1", "2", "3", "4", "5"}, {"left", "right"}}}};
  return protocol;
}

SessionSchedule smallSchedule(const Protocol& protocol) {
  return scheduleOf(protocol, 0, 1, 17);
}

SessionRun::SessionRun(const Protocol& protocol, const SessionSchedule& schedule, SessionSink& sink,
                       const SessionDone& done)
    : flow(protocol, schedule, done,
           SessionFlowOptions{.screen = {640, 480, 60},
                              .intervalNanoseconds = kFrameNanoseconds,
                              .utcNow = [this] { return utcText(now / 1'000'000); }},
           sink),
      protocol_(protocol) {
  flow.update(now);
}

void SessionRun::frame(int64_t nanoseconds) {
  now += nanoseconds;
  flow.update(now);
  if (whenShown) {
    whenShown(now + 1'000'000);
  }
  flow.frameShown(now + 1'000'000);
}

void SessionRun::press(Key key) {
  input(KeyEvent{key, true, {}});
}

void SessionRun::release(Key key) {
  input(KeyEvent{key, false, {}});
}

void SessionRun::tap(Key key) {
  press(key);
  frame();
  release(key);
  frame();
}

const PageScreen* SessionRun::page() {
  screen_ = flow.screen();
  return std::get_if<PageScreen>(&screen_);
}

void SessionRun::answerTrial() {
  const TrialPlan plan = *flow.trialPlan();
  frame();
  frame();
  tap(answer ? *answer : digit(plan.caseIndex + 1));
}

void SessionRun::goOn(const std::function<bool()>& until) {
  for (int taps = 0; !flow.isOver() && !until(); ++taps) {
    ASSERT_LT(taps, 10000) << "the session does not end";
    screen_ = flow.screen();
    if (inTrial()) {
      answerTrial();
    } else if (const auto* form = std::get_if<FormScreen>(&screen_)) {
      const auto focus = static_cast<size_t>(form->focus);
      tap(focus < form->entries.size() && form->entries[focus].isEmpty() ? Key::kRight : Key::kEnter);
    } else if (const auto* text = std::get_if<PageScreen>(&screen_); text != nullptr && text->waitSeconds > 0) {
      frame();
    } else {
      tap(Key::kEnter);
    }
  }
}

}  // namespace ocelli::test
