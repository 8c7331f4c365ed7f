// The way without a database gives what the way through one does, row by row.
#include "analysis/power/simulated_dataset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "analysis/dataset/database.h"
#include "analysis/dataset/exclusions.h"
#include "analysis/report/report_task.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

SimulationPlan studyOf(std::vector<int> sessions, uint64_t seed) {
  SimulationPlan plan;
  plan.kind = SubjectKind::kGenerator;
  plan.sessions = std::move(sessions);
  plan.seed = seed;
  return plan;
}

/// All of a trial but where its row stands.
auto contentOf(const Trial& t) {
  return std::tie(t.subject, t.session, t.planIndex, t.blockIndex, t.block, t.task, t.caseIndex, t.caseLabel, t.view,
                  t.attempt, t.simulated, t.subjectKind, t.moving, t.exposureSeconds, t.objects, t.duplicateColors,
                  t.longestSeconds, t.answer, t.expected, t.correct, t.censored, t.responseSeconds, t.measures,
                  t.frames, t.droppedFrames, t.timingVerdict);
}
auto contentOf(const Subject& s) {
  return std::tie(s.id, s.kind, s.simulated, s.slot);
}
auto contentOf(const Session& s) {
  return std::tie(s.subject, s.number, s.simulated, s.plannedTrials, s.completedTrials, s.runs, s.ending, s.forced);
}
auto contentOf(const FormAnswer& a) {
  return std::tie(a.subject, a.session, a.form, a.field, a.answer, a.simulated);
}
auto contentOf(const Consent& c) {
  return std::tie(c.subject, c.session, c.agreed);
}

/// Databases number their rows in the order in which threads write them.
template <class Row>
std::vector<Row> sorted(std::vector<Row> rows) {
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return contentOf(a) < contentOf(b); });
  return rows;
}

template <class Row>
void expectSameRows(const std::vector<Row>& fast, const std::vector<Row>& slow, const char* what) {
  ASSERT_EQ(fast.size(), slow.size()) << what;
  const std::vector<Row> fastRows = sorted(fast);
  const std::vector<Row> slowRows = sorted(slow);
  for (size_t i = 0; i < fastRows.size(); ++i) {
    ASSERT_TRUE(contentOf(fastRows[i]) == contentOf(slowRows[i])) << what << " " << i;
  }
}

void expectSameData(const Dataset& fast, const Dataset& slow) {
  expectSameRows(fast.trials, slow.trials, "trial");
  expectSameRows(fast.subjects, slow.subjects, "subject");
  expectSameRows(fast.sessions, slow.sessions, "session");
  expectSameRows(fast.answers, slow.answers, "answer");
  expectSameRows(fast.consents, slow.consents, "consent");
  EXPECT_EQ(fast.otherAttempts.size(), slow.otherAttempts.size());
  EXPECT_EQ(fast.leftOut.size(), slow.leftOut.size());
  ASSERT_EQ(slow.sources.size(), 1U);
  EXPECT_EQ(fast.sources.front().protocolSha256, slow.sources.front().protocolSha256);
  EXPECT_EQ(fast.sources.front().protocolText, slow.sources.front().protocolText);
  EXPECT_EQ(fast.sources.front().programVersion, slow.sources.front().programVersion);
}

TEST(SimulatedDataset, IsWhatTheDatabaseOfTheSameStudyHolds) {
  const Protocol protocol = readProtocol(OCELLI_SOURCE_DIR "/protocols/rosen2010.json");
  SimulationPlan plan = studyOf({2, 1}, 42);
  plan.effects.at("find", "log_seconds") = 3.5;  // so that some searches take too long
  const test::TemporaryFolder folder;
  simulateStudy(protocol, folder / "study.sqlite", plan);
  const Dataset fast = simulatedDataset(protocol, plan);
  const Dataset slow = readDatabase((folder / "study.sqlite").string());
  EXPECT_EQ(fast.trials.size(), 3U * 90);
  EXPECT_GT(std::count_if(fast.trials.begin(), fast.trials.end(), [](const Trial& t) { return *t.censored; }), 0);
  expectSameData(fast, slow);

  AnalysisPlan exclusions = defaultPlan();
  exclusions.exclusions = {{"sessions_completed", ExclusionTest::kAtMost, "", 1, "came once"},
                           {"form:experience", ExclusionTest::kIs, "none", 0, "has no experience"}};
  const AnalysisData fastAnalysis = applyPlan(fast, exclusions);
  const AnalysisData slowAnalysis = applyPlan(slow, exclusions);
  EXPECT_LT(fastAnalysis.data.trials.size(), fast.trials.size());
  expectSameData(fastAnalysis.data, slowAnalysis.data);
  EXPECT_EQ(fastAnalysis.flow.analysed, slowAnalysis.flow.analysed);
  EXPECT_EQ(fastAnalysis.flow.excluded, slowAnalysis.flow.excluded);
  EXPECT_EQ(fastAnalysis.flow.consented, slowAnalysis.flow.consented);
  EXPECT_EQ(fastAnalysis.flow.completedSessions, slowAnalysis.flow.completedSessions);
}

TEST(SimulatedDataset, WithoutAnswersAllElseIsTheSame) {
  const Protocol protocol = readProtocol(OCELLI_SOURCE_DIR "/protocols/rosen2010.json");
  Dataset told = simulatedDataset(protocol, studyOf({1, 1}, 5));
  const Dataset untold = simulatedDatasetWithoutAnswers(protocol, studyOf({1, 1}, 5));
  for (Trial& trial : told.trials) {
    trial.answer.clear();
    trial.expected.clear();
  }
  expectSameData(untold, told);
}

TEST(SimulatedDataset, OfAnotherSeedIsAnother) {
  const Protocol protocol = readProtocol(OCELLI_SOURCE_DIR "/protocols/short.json");
  const Dataset one = simulatedDataset(protocol, studyOf({1}, 1));
  const Dataset two = simulatedDataset(protocol, studyOf({1}, 2));
  ASSERT_FALSE(one.trials.empty());
  EXPECT_NE(one.trials.front().responseSeconds, two.trials.front().responseSeconds);
}

}  // namespace
}  // namespace ocelli
