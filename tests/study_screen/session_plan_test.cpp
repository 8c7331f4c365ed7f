#include "study/screen/session_plan.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "oc_core/base/error.h"
#include "study/store/trial_store.h"
#include "tests/study_session/session_harness.h"

namespace ocelli {
namespace {

class SessionPlanTest : public testing::Test {
 protected:
  SessionPlanTest() : database_(make()) {}
  ~SessionPlanTest() override { std::filesystem::remove_all(folder()); }

  static std::filesystem::path folder() {
    return std::filesystem::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
  }
  StudyDatabase make() const {
    std::filesystem::remove_all(folder());
    std::filesystem::create_directories(folder());
    return StudyDatabase::openForSessions(folder() / "study.db", protocol_, {0});
  }

  static StudyRunOptions optionsFor(const std::string& subject) {
    StudyRunOptions options;
    options.subject = subject;
    return options;
  }
  void begin(const std::string& subject, const SessionSchedule& schedule, SubjectKind kind = SubjectKind::kPerson) {
    database_.addSubject(subject, kind);
    RunRecord run;
    run.subject = subject;
    run.kind = kind;
    run.startedUtc = "2026-03-01T12:00:00.000Z";
    run.programVersion = "0.9";
    run.environment = run.timingCheck = "{}";
    TrialStore store(database_, protocol_, run, schedule);
    TrialRecord record;
    record.plan = practiceTrial(schedule, protocol_, 0, 0);
    record.screen = {1920, 1200, 60};
    store.trialBegins(0, record.plan, 1);
    store.trialEnds(0, record);
    store.flush();
  }
  /// What is said against it.
  template <class Call>
  static std::string refusal(const Call& call) {
    try {
      call();
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  }

  Protocol protocol_ = test::smallProtocol();
  StudyDatabase database_;
};

TEST_F(SessionPlanTest, aNewSubjectNeedsNoDatabase) {
  EXPECT_TRUE(planNewSession(nullptr, protocol_, optionsFor("S01")).isNewSubject);
  EXPECT_NE(
      refusal([&] { planNewSession(nullptr, protocol_, optionsFor("-S01")); }).find("the first a letter or digit"),
      std::string::npos);
}

TEST_F(SessionPlanTest, simulatedSubjectsAreNotForPeople) {
  begin("SIM", test::smallSchedule(protocol_), SubjectKind::kObserver);
  const StudyRunOptions options = optionsFor("SIM");
  EXPECT_NE(refusal([&] { planNewSession(&database_, protocol_, options); }).find("simulated"), std::string::npos);
  EXPECT_NE(refusal([&] { planResumedSession(database_, protocol_, options); }).find("simulated"), std::string::npos);
}

TEST_F(SessionPlanTest, aSessionGoesOnInTheOrderInWhichItBegan) {
  SessionSchedule schedule = test::smallSchedule(protocol_);
  begin("S01", schedule);
  const SessionPlan plan = planResumedSession(database_, protocol_, optionsFor("S01"));
  EXPECT_TRUE(plan.session.begunBefore);
  EXPECT_EQ(plan.session.done.practiceBegun,
            (std::vector<TrialPlan>{practiceTrial(schedule, protocol_, 0, 0)}));  // its next attempt is the second

  schedule.slot = 1;
  std::swap(schedule.trials[0].seed, schedule.trials[1].seed);  // as another version might have had it
  begin("S02", schedule);
  const std::string said = refusal([&] { planResumedSession(database_, protocol_, optionsFor("S02")); });
  EXPECT_NE(said.find("another order"), std::string::npos) << said;
  EXPECT_NE(said.find("0.9"), std::string::npos) << said;
}

TEST_F(SessionPlanTest, saysWhereTheScreenIsAnotherOne) {
  begin("S01", test::smallSchedule(protocol_));
  EXPECT_FALSE(screenChange(database_, "S01", {1920, 1200, 60}, 0.01).has_value());
  EXPECT_FALSE(screenChange(database_, "S01", {1920, 1200, 59.95}, 0.01).has_value());
  EXPECT_FALSE(screenChange(database_, "S02", {1280, 800, 60}, 0.01).has_value());
  EXPECT_EQ(screenChange(database_, "S01", {1280, 1200, 60}, 0.01),
            "1920x1200 at 60 Hz before, 1280x1200 at 60 Hz now");
  EXPECT_TRUE(screenChange(database_, "S01", {1920, 1200, 75}, 0.01).has_value());
}

}  // namespace
}  // namespace ocelli
