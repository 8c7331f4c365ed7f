#include "study/subject/simulate_session.h"

#include <fmt/format.h>

#include "oc_core/base/error.h"
#include "study/session/utc_time.h"

namespace ocelli {
namespace {

/// Simulated sessions take place at 9 o'clock, a week apart, from 3 January 2000 on: no person could have been there.
constexpr int64_t kBeginMilliseconds = 946'890'000'000;
constexpr int64_t kWeekMilliseconds = int64_t{7} * 24 * 3600 * 1000;
constexpr int64_t kLongestSession = int64_t{6} * 3600 * 1'000'000'000;

}  // namespace

std::string simulatedUtc(int session, int64_t nanoseconds) {
  return utcText(kBeginMilliseconds + (session - 1) * kWeekMilliseconds + nanoseconds / 1'000'000);
}

SessionEnding simulateSession(const Protocol& protocol, const SimulatedSession& session, SessionObserver& observer,
                              SessionSink& sink) {
  int64_t now = 0;
  SessionFlowOptions options;
  options.screen = session.screen;
  options.intervalNanoseconds = nanosecondsOf(1 / session.screen.refreshHertz);
  options.simulatedClock = true;
  options.kind = SubjectKind::kObserver;
  options.utcNow = [&now, number = session.schedule.session] { return simulatedUtc(number, now); };
  SessionFlow flow(protocol, session.schedule, session.done, options, sink);
  observer.beginSession(session.schedule.session);
  for (int64_t frame = 1; !flow.isOver(); ++frame) {
    // Whole frames of the rate, so that rounding does not add up.
    const auto next = static_cast<int64_t>(static_cast<double>(frame) * 1e9 / session.screen.refreshHertz);
    for (const TimedInput& input : observer.act(next)) {
      flow.handle(input);
    }
    now = next;
    flow.update(now);
    flow.frameShown(now, observer.watch(flow, now));
    if (now > kLongestSession) {
      throw WorkError(fmt::format("a simulated session has not ended after {} hours: {}",
                                  kLongestSession / 3'600'000'000'000, flow.status().step),
                      protocol.name, "look at the step: the simulated subject does not know how to get past it");
    }
  }
  sink.flush();
  if (const std::optional<std::string> failure = sink.failure()) {
    throw WorkError(*failure, protocol.name, "make room on the disk, and run it again: it goes on where it stopped");
  }
  return flow.ending();
}

}  // namespace ocelli
