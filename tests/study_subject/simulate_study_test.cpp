#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "study/store/study_database.h"
#include "study/subject/simulate_together.h"
#include "tests/base/temporary_folder.h"
#include "tests/ranks/thread_ranks.h"
#include "tests/study_subject/simulated_sessions.h"

namespace ocelli {
namespace {

/// All that a database tells of what subjects did, but for what numbers its rows have.
std::vector<std::string> storyOf(const std::filesystem::path& path) {
  const StudyDatabase database = StudyDatabase::openForReading(path);
  std::vector<std::string> story;
  for (const StoredSubject& subject : database.subjects()) {
    story.push_back(subject.id + " " + nameOf(subject.kind) + " " + std::to_string(subject.slot));
    for (const TrialRow& trial : database.trials(subject.id)) {
      std::string line = subject.id + " " + std::to_string(trial.session) + " " + trial.block + " " + trial.caseLabel +
                         " " + std::to_string(trial.attempt) + " " + trial.startedUtc + " " + trial.answer + " " +
                         std::to_string(trial.responseTicks.value_or(0));
      for (const FrameRecord& frame : database.frames(trial.trialId)) {
        line += " " + std::to_string(frame.pose.x) + "," + std::to_string(frame.shownNanoseconds);
      }
      line += " " + std::to_string(database.inputs(trial.trialId).size());
      story.push_back(line);
    }
    for (const StoredAnswer& answer : database.answers(subject.id)) {
      story.push_back(subject.id + " " + answer.record.field + " " + answer.record.answer);
    }
  }
  return story;
}

class SimulateStudy : public testing::Test {
 protected:
  void TearDown() override { setThreadCount(0); }
  std::filesystem::path file(const std::string& name) const { return folder / name; }

  test::TemporaryFolder folder;
};

TEST_F(SimulateStudy, isTheSameForAnyNumberOfThreads) {
  const Protocol protocol = test::simulatedProtocol(false);
  setThreadCount(1);
  const SimulationResult alone = simulateStudy(protocol, file("one.db"), test::observers(2));
  setThreadCount(2);
  simulateStudy(protocol, file("two.db"), test::observers(2));
  EXPECT_EQ(alone.sessions, 2);
  EXPECT_EQ(alone.sessionsBefore, 0);
  EXPECT_EQ(storyOf(file("one.db")), storyOf(file("two.db")));
  for (const StoredSubject& subject : StudyDatabase::openForReading(file("one.db")).subjects()) {
    EXPECT_EQ(subject.kind, SubjectKind::kObserver);
  }
}

TEST_F(SimulateStudy, isTheSameForAnyNumberOfRanks) {
  const Protocol protocol = test::simulatedProtocol(false);
  const SimulationPlan plan = test::observers(3);
  const SimulationResult alone = simulateStudy(protocol, file("alone.db"), plan);
  for (const int size : {2, 4}) {
    const std::filesystem::path together = file("together" + std::to_string(size) + ".db");
    for (const int sessionsBefore : {0, alone.sessions}) {
      test::runInRanks(size, [&](Ranks& ranks) {
        const SimulationResult result = simulateTogether(protocol, together, plan, ranks);
        if (ranks.isFirst()) {
          EXPECT_EQ(result.sessions, alone.sessions - sessionsBefore);
          EXPECT_EQ(result.sessionsBefore, sessionsBefore);
          EXPECT_EQ(result.trials, alone.trials);
        }
      });
    }
    EXPECT_EQ(storyOf(together), storyOf(file("alone.db")));
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
      EXPECT_EQ(entry.path().filename().string().find(".rank"), std::string::npos) << entry.path();
    }
  }
}

TEST_F(SimulateStudy, takesOverWhatAJobOfRanksLeft) {
  const Protocol protocol = test::simulatedProtocol(false);
  const SimulationPlan plan = test::observers(2);
  simulateStudy(protocol, file("alone.db"), plan);
  addSubjects(protocol, file("together.db"), plan);
  std::filesystem::copy_file(file("together.db"), file("together.db.rank1"));
  SimulationPlan second = plan;
  second.part = 1;
  second.parts = 2;
  simulateStudy(protocol, file("together.db.rank1"), second);
  test::runInRanks(2, [&](Ranks& ranks) {
    const SimulationResult result = simulateTogether(protocol, file("together.db"), plan, ranks);
    if (ranks.isFirst()) {
      EXPECT_EQ(result.sessionsBefore, 1);
    }
  });
  EXPECT_EQ(storyOf(file("together.db")), storyOf(file("alone.db")));
}

TEST_F(SimulateStudy, goesOnWhereItStoppedAsIfItHadNot) {
  const Protocol protocol = test::simulatedProtocol(false);
  simulateStudy(protocol, file("whole.db"), test::observers(1, 2));
  // The renderer fails after some images, in the midst of a session.
  SimulationPlan failing = test::observers(1, 2);
  failing.makeRenderer = [] {
    return [drawn = 0](const StudyCamera& camera, const Mesh& mesh) mutable {
      if (++drawn > 150) {
        throw WorkError("the renderer has gone", "test", "none");
      }
      return rasterizeStudy(camera, mesh);
    };
  };
  EXPECT_THROW(simulateStudy(protocol, file("parts.db"), failing), WorkError);
  {
    const StudyDatabase database = StudyDatabase::openForReading(file("parts.db"));
    ASSERT_TRUE(database.session("sim-0001", 1).has_value());
    EXPECT_GT(database.session("sim-0001", 1)->completedTrials, 0);
    EXPECT_LT(database.session("sim-0001", 1)->completedTrials, database.session("sim-0001", 1)->plannedTrials);
  }
  EXPECT_EQ(simulateStudy(protocol, file("parts.db"), test::observers(1, 2)).sessions, 2);
  const auto completed = [&](const std::string& name) {
    const StudyDatabase database = StudyDatabase::openForReading(file(name));
    std::vector<std::tuple<int, int, std::string, int64_t, size_t>> all;
    for (const TrialRow& trial : database.trials()) {
      if (trial.ending == TrialEnding::kCompleted) {
        all.emplace_back(trial.session, trial.planIndex, trial.answer, trial.responseTicks.value_or(0),
                         database.frames(trial.trialId).size());
      }
    }
    return all;
  };
  EXPECT_EQ(completed("parts.db"), completed("whole.db"));
  EXPECT_EQ(simulateStudy(protocol, file("parts.db"), test::observers(1, 2)).sessions, 0) << "all is done";
}

TEST_F(SimulateStudy, addsASessionWithWhatWasLearnedInTheOneBefore) {
  const Protocol protocol = test::simulatedProtocol(false);
  simulateStudy(protocol, file("whole.db"), test::observers(1, 2));
  simulateStudy(protocol, file("parts.db"), test::observers(1, 1));
  EXPECT_EQ(simulateStudy(protocol, file("parts.db"), test::observers(1, 2)).sessionsBefore, 1);
  EXPECT_EQ(storyOf(file("parts.db")), storyOf(file("whole.db")));
}

TEST_F(SimulateStudy, generatesMarkedData) {
  const Protocol protocol = test::simulatedProtocol(false);
  SimulationPlan plan = test::observers(12, 2);
  plan.kind = SubjectKind::kGenerator;
  EXPECT_EQ(simulateStudy(protocol, file("known.db"), plan).sessions, 24);
  const StudyDatabase database = StudyDatabase::openForReading(file("known.db"));
  EXPECT_EQ(database.subjects().size(), 12u);
  for (const TrialRow& trial : database.trials()) {
    EXPECT_EQ(trial.subjectKind, SubjectKind::kGenerator);
    EXPECT_EQ(trial.timingVerdict, TimingVerdict::kSimulatedClock);
  }
  EXPECT_THAT(database.runs("sim-0001", 1).at(0).record.simulation, testing::HasSubstr("residual_sd"));
}

TEST_F(SimulateStudy, refusesToMix) {
  const Protocol protocol = test::simulatedProtocol(false);
  SimulationPlan plan = test::observers(1);
  plan.kind = SubjectKind::kGenerator;
  simulateStudy(protocol, file("a.db"), plan);
  SimulationPlan otherSeed = plan;
  otherSeed.seed = 12;
  EXPECT_THROW(simulateStudy(protocol, file("a.db"), otherSeed), InputError);
  EXPECT_THROW(simulateStudy(protocol, file("a.db"), test::observers(1)), InputError) << "another kind";
  EXPECT_THROW(simulateStudy(test::simulatedProtocol(true), file("a.db"), plan), InputError) << "another protocol";
  SimulationPlan others = otherSeed;
  others.idPrefix = "more-";
  EXPECT_EQ(simulateStudy(protocol, file("a.db"), others).sessions, 1);
}

TEST(SessionsFromText, saysHowManyForHowMany) {
  EXPECT_EQ(sessionsFromText("3x2,1x1", 3, 3, "--sessions"), (std::vector<int>{3, 3, 1}));
  EXPECT_EQ(sessionsFromText("2", 2, 3, "--sessions"), (std::vector<int>{2, 2}));
  for (const char* wrong : {"", "4x3", "0x3", "3x", "x3", "3x2,", "3x4", "three", "-1x3", "1x1,1x1"}) {
    EXPECT_THROW(sessionsFromText(wrong, 3, 3, "--sessions"), InputError) << wrong;
  }
}

}  // namespace
}  // namespace ocelli
