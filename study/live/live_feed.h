// Watches what a session records, and posts its status on a board four times a second: it stands between a session and
// the sink of its records, as MarkerFeed does.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "study/live/live_board.h"
#include "study/live/time_left.h"
#include "study/protocol/schedule.h"
#include "study/session/forwarding_sink.h"
#include "study/session/session_flow.h"

namespace ocelli {

struct LiveOptions {
  /// The status tells which condition a trial has. An experimenter who knows may give it away, and so it is hidden
  /// otherwise.
  bool showsConditions = false;
  std::function<std::vector<LiveDevice>()> devices{};  ///< asked for with each status; must not wait
};

class LiveFeed : public ForwardingSink {
 public:
  static constexpr size_t kMaxTrials = 8;    ///< LiveStatus::lastTrials
  static constexpr size_t kMaxWarnings = 6;  ///< LiveStatus::warnings

  /// All but the options must outlive it. Without a board (null) it only passes on.
  LiveFeed(SessionSink& inner, const Protocol& protocol, const SessionSchedule& schedule,
           std::shared_ptr<LiveBoard> board, LiveOptions options);

  /// A frame was shown at that time since the run began, on the thread of the session. Never waits.
  void frameShown(int64_t nanoseconds, const SessionFlow& flow);
  /// The last status.
  void finish(const SessionFlow& flow);

  void trialBegins(int number, const TrialPlan& plan, int attempt) override;
  void trialEnds(int number, const TrialRecord& record, std::function<void()> acknowledged) override;
  void event(const EventRecord& record) override;

 private:
  void post(const SessionFlow& flow);

  const Protocol& protocol_;
  std::shared_ptr<LiveBoard> board_;
  LiveOptions options_;
  TimeLeft timeLeft_;
  LiveStatus status_{};      ///< what adds up
  std::string condition_{};  ///< of the trial that runs
  int64_t now_ = 0;
  std::optional<int64_t> posted_{};
};

}  // namespace ocelli
