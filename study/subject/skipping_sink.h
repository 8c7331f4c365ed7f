// Sinks for simulated sessions that are run again: because what was learned in them is needed, or because they stopped
// half way.
#pragma once

#include <map>
#include <set>

#include "study/session/session_flow.h"

namespace ocelli {

/// Stores nothing.
class NoSink final : public SessionSink {
 public:
  void consent(const ConsentRecord&) override {}
  void answer(const AnswerRecord&) override {}
  void trialBegins(int, const TrialPlan&, int) override {}
  void frames(int, std::span<const FrameRecord>) override {}
  void inputs(int, std::span<const InputRecord>) override {}
  void gaze(int, std::span<const GazeRecord>) override {}
  void trialEnds(int, const TrialRecord&, std::function<void()>) override {}
  void event(const EventRecord&) override {}
  void sessionEnds(SessionEnding, const std::string&) override {}
  void flush() override {}
  std::optional<std::string> failure() const override { return std::nullopt; }
};

/// Passes on what is not stored yet of a session that runs again from its begin: a simulated subject does the same
/// again, so the rest is what it would have been.
class SkippingSink final : public SessionSink {
 public:
  /// `sink` must outlive it.
  SkippingSink(SessionSink& sink, SessionDone done);

  void consent(const ConsentRecord& record) override;
  void answer(const AnswerRecord& record) override;
  void trialBegins(int number, const TrialPlan& plan, int attempt) override;
  void frames(int number, std::span<const FrameRecord> records) override;
  void inputs(int number, std::span<const InputRecord> records) override;
  void gaze(int number, std::span<const GazeRecord> records) override;
  void trialEnds(int number, const TrialRecord& record, std::function<void()> acknowledged) override;
  void event(const EventRecord& record) override;
  void sessionEnds(SessionEnding ending, const std::string& utc) override;
  void flush() override { sink_.flush(); }
  std::optional<std::string> failure() const override { return sink_.failure(); }

 private:
  bool isStored(const TrialPlan& plan) const;

  SessionSink& sink_;
  SessionDone done_;
  bool caughtUp_ = false;            ///< something was new
  std::map<int, int> numbers_{};     ///< of trials that are passed on: theirs and ours
  std::map<int, int> attemptsOf_{};  ///< by our number
};

}  // namespace ocelli
