// Which session comes next, and what of it is done.
#include "study/store/resume.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "study/store/trial_store.h"
#include "tests/base/temporary_folder.h"
#include "tests/study_store/made_study.h"
#include "tests/study_store/study_checks.h"

namespace ocelli::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kNow = "2026-03-01T14:00:00.000Z";

class ResumeTest : public testing::Test {
 protected:
  ResumeTest() { database_.addSubject("S01", SubjectKind::kPerson); }
  SessionToRun next(const std::string& now = kNow, bool anyTime = false) const {
    return sessionToRun(database_, protocol_, "S01", now, anyTime);
  }

  TemporaryFolder folder_;
  Protocol protocol_ = madeProtocol();
  StudyDatabase database_ = StudyDatabase::openForSessions(folder_ / "study.db", protocol_);
  SessionSchedule schedule_ = madeSchedule(0, 1, 2);
};

TEST_F(ResumeTest, BeginsWithTheFirstSession) {
  const SessionToRun first = next();
  EXPECT_EQ(first.session, 1);
  EXPECT_FALSE(first.begunBefore);
  EXPECT_EQ(first.seed, protocol_.seed);
  EXPECT_THAT(first.done.completedTrials, IsEmpty());
}

TEST_F(ResumeTest, KnowsWhatWasDone) {
  {
    TrialStore store(database_, protocol_, madeRun("S01", 1), schedule_);
    store.consent({"Consent", "", "", true, ""});
    store.answer({"demographics", "age_band", "18-24", ""});
    store.answer({"demographics", "vision", "well", ""});
    store.event({1, "", "practice_passed", "0"});
    TrialPlan practice = schedule_.trials[0];
    practice.practice = true;
    practice.index = -1;
    storeTrial(store, 0, madeTrial(practice, 1, 1), 1, 1);
    storeTrial(store, 1, madeTrial(schedule_.trials[0], 1, 1), 1, 1);
    TrialRecord redone = madeTrial(schedule_.trials[1], 1, 1);
    redone.ending = TrialEnding::kRedone;
    storeTrial(store, 2, redone, 1, 1);
    storeTrial(store, 3, madeTrial(schedule_.trials[1], 2, 1), 1, 1);
    TrialRecord aborted = madeTrial(schedule_.trials[2], 1, 1);
    aborted.ending = TrialEnding::kAborted;
    storeTrial(store, 4, aborted, 1, 1);
    store.trialBegins(5, schedule_.trials[3], 1);  // and never ends
  }
  const SessionToRun again = next();
  EXPECT_EQ(again.session, 1);
  EXPECT_TRUE(again.begunBefore);
  EXPECT_EQ(again.seed, schedule_.seed);
  EXPECT_TRUE(again.done.consented);
  EXPECT_THAT(again.done.forms, ElementsAre("demographics"));
  EXPECT_THAT(again.done.completedTrials, ElementsAre(0, 1));
  EXPECT_THAT(again.done.attempts, ElementsAre(1, 2, 1, 1));
  EXPECT_THAT(again.done.blocksPracticed, ElementsAre(0));
}

// What staircases go on from: the case that was shown, which need not be that of the schedule, and the last answer of a
// trial that was done again.
TEST_F(ResumeTest, KnowsWhatWasShownAndAnswered) {
  {
    TrialStore store(database_, protocol_, madeRun("S01", 1), schedule_);
    TrialRecord first = madeTrial(schedule_.trials[0], 1, 1);
    first.plan.caseIndex = 1;
    first.outcome.correct = false;
    storeTrial(store, 0, first, 1, 1);
    first.attempt = 2;
    first.outcome.correct = true;
    storeTrial(store, 1, first, 1, 1);
    TrialRecord aborted = madeTrial(schedule_.trials[1], 1, 1);
    aborted.ending = TrialEnding::kAborted;
    storeTrial(store, 2, aborted, 1, 1);
  }
  const AnsweredCases answered = next().done.answered;
  ASSERT_EQ(answered.size(), 1u);
  EXPECT_EQ(answered.at(0).block, schedule_.trials[0].block);
  EXPECT_EQ(answered.at(0).view, schedule_.trials[0].view);
  EXPECT_EQ(answered.at(0).caseIndex, 1);
  EXPECT_TRUE(answered.at(0).correct);
}

TEST_F(ResumeTest, AsksAgainForAFormOfWhichAnAnswerIsMissing) {
  {
    TrialStore store(database_, protocol_, madeRun("S01", 1), schedule_);
    store.answer({"demographics", "age_band", "18-24", ""});
  }
  EXPECT_THAT(next().done.forms, IsEmpty());
}

TEST_F(ResumeTest, AsksAgainWhoDeclined) {
  {
    TrialStore store(database_, protocol_, madeRun("S01", 1), schedule_);
    store.consent({"Consent", "", "", false, ""});
    store.sessionEnds(SessionEnding::kDeclined, kNow);
  }
  EXPECT_TRUE(next().begunBefore);
  EXPECT_FALSE(next().done.consented);
}

TEST_F(ResumeTest, WaitsBetweenSessions) {
  {
    TrialStore store(database_, protocol_, madeRun("S01", 1), schedule_);
    store.consent({"Consent", "", "", true, ""});
    store.sessionEnds(SessionEnding::kCompleted, "2026-02-28T23:30:00.000Z");
  }
  // The protocol asks for 60 minutes, and midnight and the end of a month lie between.
  EXPECT_THAT(messageOf<InputError>([&] { next("2026-03-01T00:29:59.999Z"); }),
              HasSubstr("ended 59 minutes ago, and the protocol asks for 60"));
  EXPECT_EQ(next("2026-03-01T00:29:00.000Z", true).session, 2);
  const SessionToRun second = next("2026-03-01T00:30:00.000Z");
  EXPECT_EQ(second.session, 2);
  EXPECT_FALSE(second.begunBefore);
  EXPECT_FALSE(second.done.consented);  // each session has its own
}

TEST_F(ResumeTest, EndsAfterTheLastSession) {
  for (int session = 1; session <= 2; ++session) {
    TrialStore store(database_, protocol_, madeRun("S01", session), madeSchedule(0, session, 2));
    store.sessionEnds(SessionEnding::kCompleted, "2026-03-01T10:00:00.000Z");
  }
  EXPECT_THAT(messageOf<InputError>([&] { next(); }), HasSubstr("all 2 sessions"));
  EXPECT_THAT(messageOf<InputError>([&] { sessionToRun(database_, protocol_, "S02", kNow); }),
              HasSubstr("no such subject"));
}

TEST_F(ResumeTest, StopsWhereTheProtocolSaysSo) {
  protocol_.resume = ResumePolicy::kStop;
  {
    TrialStore store(database_, protocol_, madeRun("S01", 1), schedule_);
    store.consent({"Consent", "", "", true, ""});
  }
  EXPECT_TRUE(next().begunBefore);  // no trial began
  {
    TrialStore store(database_, protocol_, madeRun("S01", 1), schedule_);
    store.trialBegins(0, schedule_.trials[0], 1);
  }
  EXPECT_THAT(messageOf<InputError>([&] { next(); }), HasSubstr("not resumed"));
}

TEST_F(ResumeTest, ShowsTheRunsOfASessionInTheirOrder) {
  for (int run = 0; run < 3; ++run) {
    TrialStore store(database_, protocol_, madeRun("S01", 1), schedule_);
    if (run > 0) {
      store.sessionEnds(run == 1 ? SessionEnding::kUnwell : SessionEnding::kCompleted, kNow);
    }
  }
  const std::vector<StoredRun> runs = database_.runs("S01", 1);
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_EQ(runs[0].ending, std::nullopt);
  EXPECT_EQ(runs[1].ending, SessionEnding::kUnwell);
  EXPECT_EQ(runs[2].ending, SessionEnding::kCompleted);
  EXPECT_EQ(database_.session("S01", 1)->ending, SessionEnding::kCompleted);
  EXPECT_EQ(database_.session("S01", 1)->runs, 3);
}

}  // namespace
}  // namespace ocelli::test
