// Stores a run of a session as it happens, on a thread of its own: the caller never waits for the disk.
//
// What goes in is on the disk about half a second later, so that a program that is killed loses no more than that; the
// end of a trial is committed at once, with everything before it. Where the disk is full or gone, what came is kept in
// memory, failure() says so, and storing is tried again until it works.
#pragma once

#include <memory>

#include "study/session/session_sink.h"
#include "study/store/study_database.h"

namespace ocelli {

struct TrialStoreOptions {
  double flushSeconds = 0.5;
  /// Every commit waits for the disk. Without, a loss of power may lose the last trials, but nothing that was stored is
  /// damaged: for simulated subjects alone.
  bool durable = true;
};

class TrialStore final : public SessionSink {
 public:
  /// Stores that this run begins, and its session where this is the first run. The subject must be there already. Each
  /// store has a connection of its own; several may store different subjects at the same time. `database` must be open
  /// for sessions and outlive it. Throws WorkError where that cannot be stored.
  TrialStore(const StudyDatabase& database, const Protocol& protocol, const RunRecord& run,
             const SessionSchedule& schedule, const TrialStoreOptions& options = {});
  /// Stores what is left, if it can.
  ~TrialStore() override;

  void consent(const ConsentRecord& record) override;
  void answer(const AnswerRecord& record) override;
  void trialBegins(int number, const TrialPlan& plan, int attempt) override;
  void frames(int number, std::span<const FrameRecord> records) override;
  void inputs(int number, std::span<const InputRecord> records) override;
  void gaze(int number, std::span<const GazeRecord> records) override;
  void trialEnds(int number, const TrialRecord& record, std::function<void()> acknowledged = {}) override;
  void event(const EventRecord& record) override;
  void sessionEnds(SessionEnding ending, const std::string& utc) override;
  void flush() override;
  std::optional<std::string> failure() const override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ocelli
