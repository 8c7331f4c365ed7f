// The base of sinks that stand between a session and another sink: they pass on all, but for what they override.
#pragma once

#include <utility>

#include "study/session/session_sink.h"

namespace ocelli {

class ForwardingSink : public SessionSink {
 public:
  /// `inner` must outlive it.
  explicit ForwardingSink(SessionSink& inner) : inner_(inner) {}

  void consent(const ConsentRecord& record) override { inner_.consent(record); }
  void answer(const AnswerRecord& record) override { inner_.answer(record); }
  void trialBegins(int number, const TrialPlan& plan, int attempt) override {
    inner_.trialBegins(number, plan, attempt);
  }
  void frames(int number, std::span<const FrameRecord> records) override { inner_.frames(number, records); }
  void inputs(int number, std::span<const InputRecord> records) override { inner_.inputs(number, records); }
  void gaze(int number, std::span<const GazeRecord> records) override { inner_.gaze(number, records); }
  void trialEnds(int number, const TrialRecord& record, std::function<void()> acknowledged) override {
    inner_.trialEnds(number, record, std::move(acknowledged));
  }
  void event(const EventRecord& record) override { inner_.event(record); }
  void sessionEnds(SessionEnding ending, const std::string& utc) override { inner_.sessionEnds(ending, utc); }
  void flush() override { inner_.flush(); }
  std::optional<std::string> failure() const override { return inner_.failure(); }

 private:
  SessionSink& inner_;
};

}  // namespace ocelli
