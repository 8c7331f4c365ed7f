#include "analysis/dataset/exclusions.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/dataset/database.h"
#include "study/trial/trial_check.h"
#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

using ::testing::HasSubstr;

ExclusionRule rule(std::string what, ExclusionTest test, std::string text, double number = 0) {
  ExclusionRule made;
  made.what = std::move(what);
  made.test = test;
  made.text = std::move(text);
  made.number = number;
  made.reason = "as planned";
  return made;
}

struct Exclusions : ::testing::Test {
  SampleFolder folder;
  std::string path = folder.file("study.db");

  AnalysisData with(const ExclusionRule& one) const {
    AnalysisPlan plan;
    plan.exclusions = {one};
    plan.excludesForcedSessions = false;
    return applyPlan(readDatabase(path), plan);
  }
};

TEST_F(Exclusions, theProtocolsOwnRulesHold) {
  SampleStudy study(path);
  fillSmallStudy(study);
  study.addSubject("S03");
  study.addSession("S03", 1, "unwell");
  SampleTrial trial;
  trial.subject = "S03";
  study.addTrial(trial);
  study.addSubject("S04");
  study.addSession("S04", 1);
  trial.subject = "S04";
  study.addTrial(trial);
  study.addAnswer("S04", "demographics", "vision", "colour-blind");
  study.addSubject("S05");
  study.addSession("S05", 1, "declined");
  study.addConsent("S05", false);

  const AnalysisData result = applyPlan(readDatabase(path), AnalysisPlan());
  EXPECT_EQ(result.data.trials.size(), 12u);
  EXPECT_EQ(result.flow.enrolled, 5);
  EXPECT_EQ(result.flow.consented, 2);
  EXPECT_EQ(result.flow.began, 4);
  EXPECT_EQ(result.flow.completedSessions, (std::vector<int>{3, 2}));
  const std::vector<std::pair<std::string, int>> reasons{{"motion sickness", 1}, {"impaired vision", 1}};
  EXPECT_EQ(result.flow.excluded, reasons);
  EXPECT_EQ(result.flow.analysed, 2);
  EXPECT_EQ(result.flow.analysedWithSessions, (std::vector<int>{2, 2}));
  EXPECT_EQ(result.flow.trials, 14);
  EXPECT_EQ(result.flow.excludedTrials, 2);
  EXPECT_EQ(result.flow.analysedTrials, 12);
  ASSERT_EQ(result.excluded.size(), 2u);
  EXPECT_EQ(result.excluded[0].subject, "S03");
  EXPECT_EQ(result.excluded[0].rule, "ending is unwell");
  EXPECT_EQ(result.excluded[0].trials, 1);
  ASSERT_EQ(result.data.leftOut.size(), 3u);  // two trials, and the answer of S04
  EXPECT_EQ(result.data.leftOut[0].why, "motion sickness (ending is unwell)");
  EXPECT_EQ(result.dataSha256, dataHash(readDatabase(path)));

  AnalysisPlan without;
  without.usesProtocolExclusions = false;
  EXPECT_EQ(applyPlan(readDatabase(path), without).data.trials.size(), 14u);
}

TEST_F(Exclusions, theCriterionOfPracticeHoldsForEachViewWhereTheProtocolSaysSo) {
  for (const bool eachView : {false, true}) {
    path = folder.file(eachView ? "each.db" : "any.db");
    std::string protocol = kSampleProtocol;
    if (eachView) {
      const std::string criterion = R"("least_correct": 2)";
      protocol.replace(protocol.find(criterion), criterion.size(), criterion + R"(, "each_view": true)");
    }
    SampleStudy study(path, protocol);
    fillSmallStudy(study);
    study.addSubject("S03");
    study.addSession("S03", 1);
    SampleTrial trial;
    trial.subject = "S03";
    study.addTrial(trial);
    // Two right ones in a row in one view alone.
    for (const auto& [view, right] : std::vector<std::pair<const char*, bool>>{
             {"ppc", true}, {"ppc", true}, {"gc", true}, {"gc", false}, {"gc", true}}) {
      trial.plan.reset();
      trial.view = view;
      trial.correct = right;
      study.addTrial(trial);
    }
    EXPECT_EQ(with(rule("practice_criterion", ExclusionTest::kAlways, "")).data.trials.size(), eachView ? 12u : 13u);
  }
}

TEST_F(Exclusions, eachRuleTakesWhatItSays) {
  SampleStudy study(path);
  fillSmallStudy(study);
  study.addSubject("S03");
  study.addSession("S03", 1, "aborted", true);
  for (int i = 0; i < 2; ++i) {
    SampleTrial trial;
    trial.subject = "S03";
    trial.plan.reset();
    trial.correct = i == 0;
    study.addTrial(trial);
    trial.plan = i;
    trial.frames = 10;
    trial.dropped = i;
    trial.verdict = i == 0 ? "good" : "dropped_frames";
    study.addTrial(trial);
  }
  // S03 has 2 of the 14 trials; S02 one time-out among 6.
  EXPECT_EQ(with(rule("subject", ExclusionTest::kIs, "S03")).data.trials.size(), 12u);
  EXPECT_EQ(with(rule("subject", ExclusionTest::kIsNot, "S03")).data.trials.size(), 2u);
  EXPECT_EQ(with(rule("ending", ExclusionTest::kIsNot, "completed")).data.trials.size(), 12u);
  EXPECT_EQ(with(rule("sessions_completed", ExclusionTest::kAtMost, "", 1)).data.trials.size(), 12u);
  EXPECT_EQ(with(rule("timeout_share", ExclusionTest::kAtLeast, "", 0.1)).data.trials.size(), 8u);
  EXPECT_EQ(with(rule("timeout_share", ExclusionTest::kAtLeast, "", 0.2)).data.trials.size(), 14u);
  EXPECT_EQ(with(rule("dropped_share", ExclusionTest::kAtLeast, "", 0.05)).data.trials.size(), 12u);
  EXPECT_EQ(with(rule("trial_dropped_share", ExclusionTest::kAtLeast, "", 0.05)).data.trials.size(), 13u);
  EXPECT_EQ(with(rule("timing_verdict", ExclusionTest::kIsNot, "good")).data.trials.size(), 13u);
  EXPECT_EQ(with(rule("practice_criterion", ExclusionTest::kAlways, "")).data.trials.size(), 12u);
  EXPECT_EQ(with(rule("incomplete_session", ExclusionTest::kAlways, "")).data.trials.size(), 12u);
  EXPECT_EQ(with(rule("forced_session", ExclusionTest::kAlways, "")).data.trials.size(), 12u);
  EXPECT_EQ(with(rule("form:vision", ExclusionTest::kIs, "normal")).data.trials.size(), 2u);
  const AnalysisData session = with(rule("forced_session", ExclusionTest::kAlways, ""));
  EXPECT_EQ(session.excluded[0].session, 1);
  EXPECT_EQ(session.excluded[0].trials, 2);
}

TEST_F(Exclusions, timesBeyondTheLimitThatAreNotTimeOutsAreLeftOutAndNamed) {
  SampleStudy study(path);
  fillSmallStudy(study);  // the limit is 60 s
  SampleTrial trial;
  trial.plan = 10;
  trial.response = 60;
  study.addTrial(trial);
  trial.plan = 11;
  trial.censored = true;
  study.addTrial(trial);
  EXPECT_EQ(applyPlan(readDatabase(path), AnalysisPlan()).flow.excludedTrials, 0);
  trial.plan = 12;
  trial.censored = false;
  trial.response = 75;
  const int64_t id = study.addTrial(trial);
  const AnalysisData result = applyPlan(readDatabase(path), AnalysisPlan());
  EXPECT_EQ(result.flow.excludedTrials, 1);
  for (const Trial& kept : result.data.trials) {
    EXPECT_NE(kept.trialId, id);
  }
  const std::string why = "it took 75 s, beyond its limit of 60 s, and is not marked as timed out";
  ASSERT_EQ(result.data.leftOut.size(), 1u);
  EXPECT_EQ(result.data.leftOut[0].id, id);
  EXPECT_EQ(result.data.leftOut[0].why, why);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_EQ(result.warnings[0],
            fmt::format("Trials that contradict themselves are left out, 1 in all: trial {} of S01 in {}: {}.", id,
                        path, why));
}

/// Tables do not hold the limit of a trial; the protocol does.
TEST(TrialCheck, theLimitOfTheBlockStandsInForThatOfTheTrial) {
  Trial trial;
  trial.responseSeconds = 61;
  EXPECT_EQ(contradictionOf(trial, std::nullopt), "");
  EXPECT_THAT(contradictionOf(trial, 60), HasSubstr("beyond its limit of 60 s"));
  trial.longestSeconds = 90;
  EXPECT_EQ(contradictionOf(trial, 60), "");
}

TEST_F(Exclusions, forcedSessionsAreLeftOutUnlessThePlanSaysOtherwiseAndNamedEitherWay) {
  SampleStudy study(path);
  fillSmallStudy(study);
  study.addSubject("S03");
  study.addSession("S03", 1, "completed", true);
  SampleTrial trial;
  trial.subject = "S03";
  study.addTrial(trial);
  AnalysisPlan plan;
  AnalysisData result = applyPlan(readDatabase(path), plan);
  EXPECT_EQ(result.flow.analysed, 2);
  ASSERT_EQ(result.excluded.size(), 1u);
  EXPECT_EQ(result.excluded[0].subject, "S03");
  EXPECT_EQ(result.excluded[0].session, 1);
  EXPECT_EQ(result.excluded[0].rule, "forced_session");
  EXPECT_THAT(result.warnings, ::testing::ElementsAre("Sessions were forced past a failed check of the screen's "
                                                      "timing, 1 in all; they are left out: session 1 of S03."));
  plan.excludesForcedSessions = false;
  result = applyPlan(readDatabase(path), plan);
  EXPECT_EQ(result.flow.analysed, 3);
  EXPECT_THAT(result.warnings, ::testing::ElementsAre(HasSubstr("they are analysed, as the plan says")));
  // A rule of the plan is not doubled.
  plan = AnalysisPlan();
  plan.exclusions = {rule("forced_session", ExclusionTest::kAlways, "")};
  result = applyPlan(readDatabase(path), plan);
  ASSERT_EQ(result.excluded.size(), 1u);
  EXPECT_EQ(result.excluded[0].reason, "as planned");
}

TEST_F(Exclusions, theLogTellsEveryRow) {
  SampleStudy study(path);
  study.addSubject("=x,\"y\"");
  study.addSession("=x,\"y\"", 1);
  SampleTrial trial;
  trial.subject = "=x,\"y\"";
  study.addTrial(trial);
  trial.plan.reset();
  study.addTrial(trial);
  const std::string log = exclusionLogCsv(with(rule("subject", ExclusionTest::kIs, "=x,\"y\"")).data);
  EXPECT_THAT(log, HasSubstr("source,table,row,subject,session,why\r\n" + path +
                             ",final_trial,1,\"'=x,\"\"y\"\"\",1,\"as planned (subject is =x,\"\"y\"\")\"\r\n"));
  EXPECT_THAT(log, HasSubstr(path + ",trial,2,\"'=x,\"\"y\"\"\",1,practice\r\n"));
}

TEST_F(Exclusions, aPlanMustFitTheStudy) {
  SampleStudy study(path);
  fillSmallStudy(study);
  AnalysisPlan plan;
  plan.name = "other";
  plan.protocolSha256 = std::string(64, 'a');
  EXPECT_THAT(analysisErrorOf([&] { applyPlan(readDatabase(path), plan); }),
              HasSubstr("plan \"other\" is for the protocol"));
  EXPECT_THAT(analysisErrorOf([&] { with(rule("subject", ExclusionTest::kIs, "S99")); }),
              HasSubstr("no source holds subject \"S99\""));
}

TEST_F(Exclusions, nothingIsLeftOfNothing) {
  SampleStudy study(path);
  const AnalysisData result = applyPlan(readDatabase(path), AnalysisPlan());
  EXPECT_EQ(result.flow.enrolled, 0);
  EXPECT_EQ(result.flow.analysed, 0);
  EXPECT_FALSE(result.flow.consented);
  EXPECT_EQ(result.flow.consentNote, "no consent is recorded");
}

}  // namespace
}  // namespace ocelli::test
