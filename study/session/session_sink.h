// Where the records of a running session go. Calls return at once and keep their order; what a sink has acknowledged is
// on the disk.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "study/session/records.h"

namespace ocelli {

class SessionSink {
 public:
  virtual ~SessionSink() = default;

  virtual void consent(const ConsentRecord& record) = 0;
  virtual void answer(const AnswerRecord& record) = 0;
  /// A trial begins; its number among those that this run began, from 0, names it below.
  virtual void trialBegins(int number, const TrialPlan& plan, int attempt) = 0;
  virtual void frames(int number, std::span<const FrameRecord> records) = 0;
  virtual void inputs(int number, std::span<const InputRecord> records) = 0;
  virtual void gaze(int number, std::span<const GazeRecord> records) = 0;
  /// One commit of its own. `acknowledged`, where given, is called on another thread once it is on the disk.
  virtual void trialEnds(int number, const TrialRecord& record, std::function<void()> acknowledged = {}) = 0;
  virtual void event(const EventRecord& record) = 0;
  virtual void sessionEnds(SessionEnding ending, const std::string& utc) = 0;

  /// Waits until all of it is on the disk, or failed.
  virtual void flush() = 0;
  /// Why nothing can be stored any more: a full disk, a folder that has gone. Nothing where all is well.
  virtual std::optional<std::string> failure() const = 0;
};

}  // namespace ocelli
