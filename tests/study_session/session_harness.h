// Sessions for tests: a small study, a sink that remembers, and a subject with a keyboard.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "study/session/session_flow.h"

namespace ocelli::test {

struct TrialBegins {
  int number = 0;
  TrialPlan plan;
  int attempt = 0;
};
struct TrialEnds {
  int number = 0;
  TrialRecord record;
};
struct TrialFrames {
  int number = 0;
  std::vector<FrameRecord> records;
};
struct TrialInputs {
  int number = 0;
  std::vector<InputRecord> records;
};
struct TrialGaze {
  int number = 0;
  std::vector<GazeRecord> records;
};
struct SessionEnds {
  SessionEnding ending = SessionEnding::kCompleted;
};
using SinkCall = std::variant<ConsentRecord, AnswerRecord, TrialBegins, TrialFrames, TrialInputs, TrialGaze, TrialEnds,
                              EventRecord, SessionEnds>;

class FakeSink : public SessionSink {
 public:
  void consent(const ConsentRecord& record) override { add(record); }
  void answer(const AnswerRecord& record) override { add(record); }
  void trialBegins(int number, const TrialPlan& plan, int attempt) override { add(TrialBegins{number, plan, attempt}); }
  void frames(int number, std::span<const FrameRecord> records) override {
    add(TrialFrames{number, {records.begin(), records.end()}});
  }
  void inputs(int number, std::span<const InputRecord> records) override {
    add(TrialInputs{number, {records.begin(), records.end()}});
  }
  void gaze(int number, std::span<const GazeRecord> records) override {
    add(TrialGaze{number, {records.begin(), records.end()}});
  }
  void trialEnds(int number, const TrialRecord& record, std::function<void()>) override {
    add(TrialEnds{number, record});
  }
  void event(const EventRecord& record) override { add(record); }
  void sessionEnds(SessionEnding ending, const std::string&) override { add(SessionEnds{ending}); }
  void flush() override {}
  std::optional<std::string> failure() const override {
    return calls.size() >= failsAfter ? std::optional<std::string>("the disk is full") : std::nullopt;
  }

  template <class Call>
  std::vector<Call> all() const {
    std::vector<Call> found;
    for (const SinkCall& call : calls) {
      if (const auto* is = std::get_if<Call>(&call)) {
        found.push_back(*is);
      }
    }
    return found;
  }
  bool hasEvent(const std::string& what) const;
  std::vector<FrameRecord> framesOf(int number) const;
  std::vector<InputRecord> inputsOf(int number) const;

  std::vector<SinkCall> calls;
  size_t failsAfter = static_cast<size_t>(-1);

 private:
  template <class Call>
  void add(Call call) {
    calls.emplace_back(std::in_place_type<Call>, std::move(call));
  }
};

/// What a store would tell of a session that left these calls.
SessionDone doneAfter(std::span<const SinkCall> calls, const SessionSchedule& schedule, const Protocol& protocol);

/// A trial of it asks for a digit: the right one is that of its case, from 1. It ends after two seconds.
std::shared_ptr<const TaskBlock> digitTask(int cases);

/// Consent, demographics of two fields, a welcome; block "first" of 3 cases in both views, with practice, feedback and
/// a break after each 2 trials; block "second" of 2 cases; a survey.
Protocol smallProtocol();
SessionSchedule smallSchedule(const Protocol& protocol);

constexpr int64_t kFrameNanoseconds = 16'666'667;

/// A running session, frame by frame.
class SessionRun {
 public:
  SessionRun(const Protocol& protocol, const SessionSchedule& schedule, SessionSink& sink,
             const SessionDone& done = {});

  /// The time between frames passes, and one is shown.
  void frame(int64_t nanoseconds = kFrameNanoseconds);
  void press(Key key);
  void release(Key key);
  void input(const InputEvent& event) { flow.handle({event, now}); }
  /// Both, with two frames.
  void tap(Key key);

  /// Does what the screen asks for, by keys alone; trials are answered right. Stops where `until` says, which is asked
  /// after each tap, or when the session is over.
  void goOn(const std::function<bool()>& until = [] { return false; });
  bool inTrial() const { return flow.trial() != nullptr; }
  const PageScreen* page();

  int64_t now = 5'000'000'000;  ///< clocks do not begin at 0
  /// Digits to answer with instead of the right ones.
  std::optional<Key> answer{};
  /// Called with the time of each frame, before the session is told of it.
  std::function<void(int64_t nanoseconds)> whenShown{};
  SessionFlow flow;

  /// Two frames, and the right digit, or `answer`.
  void answerTrial();

 private:
  const Protocol& protocol_;
  SessionScreen screen_{};
};

}  // namespace ocelli::test
