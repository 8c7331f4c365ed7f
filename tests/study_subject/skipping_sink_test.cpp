#include "study/subject/skipping_sink.h"

#include <gtest/gtest.h>

#include "tests/study_session/session_harness.h"

namespace ocelli {
namespace {

TEST(SkippingSink, passesOnWhatIsNotStoredYetUnderNumbersOfItsOwn) {
  test::FakeSink sink;
  SessionDone done;
  done.completedTrials = {0};
  done.attempts = {1, 1, 0};
  done.consented = true;
  done.forms = {"demographics"};
  done.blocksPracticed = {0};
  SkippingSink rest(sink, done);
  rest.consent({});
  rest.answer({"demographics", "age", "20", ""});
  rest.event({0, "", "page", "welcome"});
  TrialPlan practice;
  practice.index = -1;
  practice.practice = true;
  rest.trialBegins(0, practice, 1);
  rest.trialEnds(0, {}, {});
  for (int i = 0; i < 3; ++i) {
    TrialPlan plan;
    plan.index = i;
    rest.trialBegins(i + 1, plan, 1);
    const FrameRecord frame;
    rest.frames(i + 1, {&frame, 1});
    TrialRecord record;
    record.plan = plan;
    rest.trialEnds(i + 1, record, {});
  }
  rest.answer({"survey", "find", "4", ""});
  rest.sessionEnds(SessionEnding::kCompleted, "");

  EXPECT_TRUE(sink.all<ConsentRecord>().empty());
  EXPECT_TRUE(sink.all<EventRecord>().empty()) << "it came before anything new";
  ASSERT_EQ(sink.all<AnswerRecord>().size(), 1u);
  const auto begun = sink.all<test::TrialBegins>();
  ASSERT_EQ(begun.size(), 2u);
  EXPECT_EQ(begun[0].number, 0);
  EXPECT_EQ(begun[0].plan.index, 1);
  EXPECT_EQ(begun[0].attempt, 2) << "it had begun once before";
  EXPECT_EQ(begun[1].number, 1);
  EXPECT_EQ(begun[1].attempt, 1);
  EXPECT_EQ(sink.all<test::TrialEnds>()[0].record.attempt, 2);
  EXPECT_EQ(sink.all<test::TrialFrames>().size(), 2u);
  EXPECT_EQ(sink.all<test::SessionEnds>().size(), 1u);
}

}  // namespace
}  // namespace ocelli
