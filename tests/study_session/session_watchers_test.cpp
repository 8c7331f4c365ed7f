// What watches a session and changes nothing in it: samples of gaze, and steps that tell no condition.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/study_session/session_harness.h"

namespace ocelli::test {
namespace {

struct WatchedSession {
  Protocol protocol = smallProtocol();
  SessionSchedule schedule = smallSchedule(protocol);
  FakeSink sink{};
};

TEST(SessionWatchers, gazeIsOfTheTrialThatRuns) {
  WatchedSession watched;
  SessionRun run(watched.protocol, watched.schedule, watched.sink);
  const auto look = [&](int64_t nanoseconds, double x) {
    const GazeRecord sample{nanoseconds, 0, true, x, 0, {}};
    run.flow.gaze(std::span(&sample, 1));
  };
  look(run.now, -1);
  run.goOn([&] { return run.inTrial(); });
  look(1, -2);  // from before its first frame, and late
  for (int i = 0; i < 60; ++i) {
    look(run.now, i);
    run.frame();
  }
  run.answerTrial();
  ASSERT_FALSE(run.inTrial());
  look(run.now, -3);
  run.goOn();
  const int64_t begins = watched.sink.all<TrialEnds>()[0].record.startedNanoseconds;
  std::vector<double> kept;
  int lastNumber = 0;
  for (const TrialGaze& piece : watched.sink.all<TrialGaze>()) {
    lastNumber = std::max(lastNumber, piece.number);
    for (const GazeRecord& record : piece.records) {
      kept.push_back(record.x);
      EXPECT_GE(record.nanoseconds, begins);
    }
  }
  EXPECT_EQ(lastNumber, 0);
  ASSERT_EQ(kept.size(), 60u);
  for (int i = 0; i < 60; ++i) {
    EXPECT_EQ(kept[static_cast<size_t>(i)], i);
  }
  // They come in pieces while the trial runs, so that a run that is killed loses little.
  EXPECT_GT(watched.sink.all<TrialGaze>().size(), 1u);
}

TEST(SessionWatchers, aSessionIsTheSameWithAndWithoutGaze) {
  std::vector<int64_t> calls;
  for (const bool looks : {false, true}) {
    WatchedSession watched;
    SessionRun run(watched.protocol, watched.schedule, watched.sink);
    run.whenShown = [&](int64_t nanoseconds) {
      const GazeRecord sample{nanoseconds, 1, true, 5, 5, {}};
      if (looks) {
        run.flow.gaze(std::span(&sample, 1));
      }
    };
    run.goOn();
    calls.push_back(static_cast<int64_t>(watched.sink.calls.size() - watched.sink.all<TrialGaze>().size()));
    EXPECT_EQ(watched.sink.all<TrialGaze>().empty(), !looks);
  }
  EXPECT_EQ(calls[0], calls[1]);
}

TEST(SessionWatchers, theBlindStepTellsNoConditionAndNoTitleOfAPage) {
  WatchedSession watched;
  SessionRun run(watched.protocol, watched.schedule, watched.sink);
  int trials = 0;
  run.goOn([&] {
    const SessionStatus status = run.flow.status();
    for (const TrialView view : {TrialView::kReference, TrialView::kOther}) {
      EXPECT_EQ(status.blindStep.find(", " + watched.protocol.nameOf(view)), std::string::npos) << status.blindStep;
    }
    EXPECT_FALSE(status.blindStep.starts_with("page "));
    trials += status.blindStep.starts_with("trial ") ? 1 : 0;
    return false;
  });
  EXPECT_GT(trials, 0);
  EXPECT_TRUE(run.flow.status().ended);
}

}  // namespace
}  // namespace ocelli::test
