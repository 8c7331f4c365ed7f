#include "study/subject/session_observer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "oc_core/base/error.h"
#include "study/subject/simulate_session.h"
#include "tests/study_session/session_harness.h"
#include "tests/study_subject/simulated_sessions.h"

namespace ocelli {
namespace {

using test::FakeSink;

FakeSink simulate(const Protocol& protocol, int session, SessionObserver& observer) {
  FakeSink sink;
  const SessionSchedule schedule = scheduleOf(protocol, 0, session, 3);
  EXPECT_EQ(simulateSession(protocol, {schedule, test::kSmallScreen}, observer, sink), SessionEnding::kCompleted);
  return sink;
}

TEST(SessionObserver, goesThroughWholeSessionsOfAllTasks) {
  const Protocol protocol = test::simulatedProtocol();
  SessionObserver observer(protocol, {test::kSmallScreen}, 5);
  const FakeSink sink = simulate(protocol, 1, observer);
  std::set<std::string> tasks;
  size_t completed = 0;
  for (const test::TrialEnds& end : sink.all<test::TrialEnds>()) {
    EXPECT_EQ(end.record.ending, TrialEnding::kCompleted);
    EXPECT_EQ(end.record.timing.verdict, TimingVerdict::kSimulatedClock);
    EXPECT_EQ(end.record.startedUtc.substr(0, 10), "2000-01-03");
    tasks.insert(end.record.plan.task);
    completed += end.record.plan.practice ? 0 : 1;
    // What is asked for is answered: only the search may come to its limit.
    EXPECT_TRUE(end.record.plan.task == "find" || !end.record.outcome.censored);
  }
  EXPECT_THAT(tasks, testing::ElementsAre("count", "find", "path"));
  EXPECT_EQ(completed, scheduleOf(protocol, 0, 1, 3).trials.size());
  ASSERT_EQ(sink.all<ConsentRecord>().size(), 1u);
  EXPECT_TRUE(sink.all<ConsentRecord>()[0].agreed);
  ASSERT_EQ(sink.all<AnswerRecord>().size(), 1u);
  EXPECT_EQ(sink.all<AnswerRecord>()[0].answer, "normal") << "it is not excluded";
  ASSERT_EQ(sink.all<test::SessionEnds>().size(), 1u);

  // The survey comes after the last session.
  const FakeSink second = simulate(protocol, 2, observer);
  ASSERT_EQ(second.all<AnswerRecord>().size(), 1u);
  EXPECT_EQ(second.all<AnswerRecord>()[0].form, "survey");
}

TEST(SessionObserver, aTaskThatIsUnknownIsAnError) {
  Protocol protocol = test::simulatedProtocol(false);
  for (ProtocolBlock& block : protocol.blocks) {
    block.taskName = "search";
  }
  SessionObserver observer(protocol, {test::kSmallScreen}, 5);
  FakeSink sink;
  const SessionSchedule schedule = scheduleOf(protocol, 0, 1, 3);
  EXPECT_THROW(simulateSession(protocol, {schedule, test::kSmallScreen}, observer, sink), InputError);
}

TEST(SessionObserver, doesTheSameForTheSameSeed) {
  const Protocol protocol = test::simulatedProtocol(false);
  const auto outcomes = [&](uint64_t seed) {
    SessionObserver observer(protocol, {test::kSmallScreen}, seed);
    std::vector<std::pair<std::string, int64_t>> all;
    for (const test::TrialEnds& end : simulate(protocol, 1, observer).all<test::TrialEnds>()) {
      all.emplace_back(end.record.outcome.answer, end.record.outcome.responseTicks);
    }
    return all;
  };
  const auto first = outcomes(5);
  EXPECT_EQ(first, outcomes(5));
  EXPECT_NE(first, outcomes(6));
}

TEST(SessionObserver, onABlackScreenFindsNothingAndIsNotRightMoreOftenThanByChance) {
  const Protocol protocol = test::simulatedProtocol(false);
  const StudyRenderer black = [](const StudyCamera& camera, const Mesh&) {
    return std::visit([](const auto& each) { return FragmentImage(each.width(), each.height()); }, camera);
  };
  SessionObserver observer(protocol, {test::kSmallScreen, black}, 5);
  for (const test::TrialEnds& end : simulate(protocol, 1, observer).all<test::TrialEnds>()) {
    if (end.record.plan.task == "find") {
      EXPECT_TRUE(end.record.outcome.censored);
    } else if (end.record.plan.task == "count") {
      EXPECT_EQ(end.record.outcome.answer, "4") << "the least that can be chosen";
    }
  }
}

TEST(SessionObserver, hashesTheImagesThatItLooksAt) {
  const Protocol protocol = test::simulatedProtocol(false);
  SessionObserver observer(protocol, {test::kSmallScreen, rasterizeStudy, true}, 5);
  const FakeSink sink = simulate(protocol, 1, observer);
  size_t hashed = 0;
  size_t frames = 0;
  for (const test::TrialFrames& part : sink.all<test::TrialFrames>()) {
    for (const FrameRecord& frame : part.records) {
      ++frames;
      hashed += frame.pixelHash ? 1 : 0;
    }
  }
  // Three to four fixations a second of 60 frames, of those frames that show a scene.
  EXPECT_GT(hashed, frames / 60);
  EXPECT_LT(hashed, frames / 10);
}

}  // namespace
}  // namespace ocelli
