// Runs a session with a simulated observer, frame by frame, on a clock of its own: as fast as it can.
#pragma once

#include "study/subject/session_observer.h"

namespace ocelli {

struct SimulatedSession {
  /// Of a session; `done` is for one that is resumed by a subject that knows nothing of it any more.
  const SessionSchedule& schedule;
  TrialScreen screen{};
  SessionDone done{};
};

/// The time of day in records of session `session`, some time after its begin: it is made up, and always the same.
std::string simulatedUtc(int session, int64_t nanoseconds);

/// Throws WorkError where the sink fails, or the session does not come to an end.
SessionEnding simulateSession(const Protocol& protocol, const SimulatedSession& session, SessionObserver& observer,
                              SessionSink& sink);

}  // namespace ocelli
