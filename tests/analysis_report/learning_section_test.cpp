#include "analysis/report/learning_section.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/analysis_report/hand_made_trials.h"
#include "tests/analysis_report/section_study.h"

namespace ocelli::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kT2 = 4.302652729911;  // of 97.5 %, 2 degrees of freedom

ReportDocument learningOf(const SectionStudy& study, const std::vector<std::string>& tasks = {"find"}) {
  return documentOf(study.analysis, [&](ReportWork& work) { addLearningSection(work, rowsOf(tasks)); });
}

/// Three subjects in two sessions. With ppc two of them halve their times and one stays; with gc all take 4 s always.
SectionStudy learners() {
  SectionStudy study;
  for (const auto& [subject, second] : {std::pair{"S1", 4.0}, std::pair{"S2", 4.0}, std::pair{"S3", 8.0}}) {
    study.add(subject, 1, kPpc, 8);
    study.add(subject, 1, kGc, 4);
    study.add(subject, 2, kPpc, second);
    study.add(subject, 2, kGc, 4);
  }
  return study;
}

TEST(LearningSection, slopesAreRatiosOfGeometricMeansFromSessionToSession) {
  const ReportDocument document = learningOf(learners());
  const std::string table = "learning-find-times-trends";
  // Logarithms of the ratios are -ln 2, -ln 2 and 0: mean -2/3 ln 2, standard deviation ln 2 / sqrt 3.
  const double log2 = std::log(2.0);
  EXPECT_NEAR(*cellValue(document, table, "From session to session, ppc (3 subjects)", "Estimate"),
              std::exp(-2 * log2 / 3), 1e-12);
  const Cell& lower = originOf(document, table + "/from-session-to-session-ppc-3-subjects/lower");
  EXPECT_NEAR(*lower.value, std::exp(-2 * log2 / 3 - kT2 * log2 / 3), 1e-9);
  const Cell& p = originOf(document, table + "/from-session-to-session-ppc-3-subjects/p");
  // t = -2 with 2 degrees of freedom: p = 1 - t / sqrt(2 + t^2) = 1 - 2 / sqrt 6.
  EXPECT_NEAR(*p.value, 1 - 2 / std::sqrt(6.0), 1e-12);
  EXPECT_NEAR(*cellValue(document, table, "From session to session, gc / ppc (3 subjects)", "Estimate"),
              std::exp(2 * log2 / 3), 1e-12);
  // Nothing changes with gc, in nobody: no interval.
  EXPECT_EQ(cellText(document, table, "From session to session, gc (3 subjects)", "Estimate"), "1.00");
  EXPECT_EQ(cellText(document, table, "From session to session, gc (3 subjects)", "95 % interval"), "-");
  EXPECT_TRUE(hasFigure(document, "figure-learning-find"));
}

TEST(LearningSection, meansAreOfSubjects) {
  SectionStudy study = learners();
  study.add("S3", 2, kPpc, 8);  // once more: S3 counts no more for it
  const ReportDocument document = learningOf(study);
  // (ln 4 + ln 4 + ln 8) / 3.
  EXPECT_NEAR(*cellValue(document, "learning-find-times", "Session 2", "ppc"), std::cbrt(4.0 * 4 * 8), 1e-12);
  EXPECT_NEAR(*cellValue(document, "learning-find-times", "Session 2", "gc / ppc"), 4 / std::cbrt(4.0 * 4 * 8), 1e-12);
  EXPECT_EQ(cellText(document, "learning-find-times", "Session 2", "Subjects"), "3, 3, 3");
  const Cell& origin = originOf(document, "learning-find-times/session-2-ppc/estimate");
  EXPECT_THAT(origin.rows, ElementsAre(RowRef{0, 3}, RowRef{0, 7}, RowRef{0, 11}, RowRef{0, 13}));
}

TEST(LearningSection, aSlopeOfThreeSessionsIsThatOfLeastSquares) {
  SectionStudy study(3);
  const double shares[2][3] = {{0, 1, 1}, {0, 0, 1}};
  for (size_t s = 0; s < 2; ++s) {
    for (int session = 1; session <= 3; ++session) {
      for (const TrialView view : {kPpc, kGc}) {
        study.add(s == 0 ? "S1" : "S2", session, view, 1, shares[s][session - 1] > 0, "count");
      }
    }
  }
  const ReportDocument document = learningOf(study, {"count"});
  // (1 - 0) / 2 in both.
  EXPECT_EQ(cellText(document, "learning-count-right-trends", "From session to session, ppc (2 subjects)", "Estimate"),
            "0.500");
}

TEST(LearningSection, intervalsOfSharesEndWhereSharesDo) {
  SectionStudy study;
  for (const char* subject : {"S1", "S2"}) {
    for (const TrialView view : {kPpc, kGc}) {
      study.add(subject, 1, view, 1, true, "path");
      study.add(subject, 1, view, 1, subject[1] == '1', "path");
    }
  }
  const ReportDocument document = learningOf(study, {"path"});
  // Shares 1 and 0.5: 0.75 +- 12.7 * 0.25.
  EXPECT_EQ(cellText(document, "learning-path-right", "Session 1", "ppc"), "0.75 (0.00 to 1.00)");
}

/// Four searches of each view in a block, cases 0 to 3 in the given order, so long.
void addBlock(SectionStudy& study, const std::string& subject, const std::vector<int>& cases,
              const std::vector<double>& seconds) {
  for (const TrialView view : {kPpc, kGc}) {
    for (size_t i = 0; i < cases.size(); ++i) {
      study.add(subject, 1, view, seconds[i]).caseIndex = cases[i];
    }
  }
}

TEST(LearningSection, halvesAreComparedWhereCasesComeInBoth) {
  SectionStudy study;
  addBlock(study, "S1", {0, 1, 2, 3}, {8, 2, 4, 1});
  addBlock(study, "S2", {2, 3, 0, 1}, {4, 4, 8, 8});
  addBlock(study, "S3", {0, 1}, {1, 100});  // not complete
  const ReportDocument document = learningOf(study);
  const std::string table = "learning-find-times-trends";
  // Geometric means of halves are 4 and 2 of S1, 4 and 8 of S2.
  EXPECT_NEAR(*cellValue(document, "learning-find-times", "First halves of blocks", "ppc"), 4, 1e-12);
  EXPECT_NEAR(*cellValue(document, "learning-find-times", "Second halves of blocks", "gc"), 4, 1e-12);
  EXPECT_EQ(cellText(document, "learning-find-times", "First halves of blocks", "Subjects"), "2, 2, 2");
  EXPECT_NEAR(*cellValue(document, table, "Second half of a block / first, ppc (2 subjects)", "Estimate"), 1, 1e-12);
}

TEST(LearningSection, halvesThatDifferInTheirCasesAreNotCompared) {
  SectionStudy study;
  addBlock(study, "S1", {0, 1, 2, 3}, {8, 2, 4, 1});
  addBlock(study, "S2", {1, 0, 2, 3}, {4, 4, 8, 8});
  const ReportDocument document = learningOf(study);
  EXPECT_EQ(cellText(document, "learning-find-times", "First halves of blocks", "ppc"), "no such cell");
  EXPECT_THAT(reasonsOf(document), Contains(HasSubstr("halves would differ in their cases")));
}

TEST(LearningSection, timeoutsCountWithTheLimitOrAreRemovedAsPlanned) {
  SectionStudy study;
  for (const char* subject : {"S1", "S2"}) {
    study.add(subject, 1, kPpc, 15);
    study.add(subject, 1, kPpc, 60, false);
    study.add(subject, 1, kGc, 15);
  }
  EXPECT_NEAR(*cellValue(learningOf(study), "learning-find-times", "Session 1", "ppc"), 30, 1e-12);
  EXPECT_EQ(cellText(learningOf(study), "learning-find-right", "Session 1", "ppc"), "0.500");
  study.analysis.plan.findTimeouts = TimeoutTreatment::kRemoved;
  EXPECT_NEAR(*cellValue(learningOf(study), "learning-find-times", "Session 1", "ppc"), 15, 1e-12);
}

TEST(LearningSection, saysWhatItLacks) {
  EXPECT_THAT(reasonsOf(learningOf(SectionStudy())), ElementsAre("Finding: there are no trials of this task."));

  SectionStudy one;
  one.add("S1", 1, kPpc, 3);
  one.add("S1", 1, kGc, 3);
  ReportDocument document = learningOf(one);
  EXPECT_EQ(cellText(document, "learning-find-times", "Session 1", "ppc"), "no such cell");
  EXPECT_THAT(reasonsOf(document), Contains("Session 1, ppc; Session 1, gc; Session 1, gc / ppc: only one subject has "
                                            "such trials."));
  EXPECT_THAT(reasonsOf(document), Contains(HasSubstr("no subject has such trials in two sessions")));

  SectionStudy oneView;
  oneView.add("S1", 1, kPpc, 3);
  oneView.add("S2", 1, kPpc, 5);
  document = learningOf(oneView);
  EXPECT_NEAR(*cellValue(document, "learning-find-times", "Session 1", "ppc"), std::sqrt(15.0), 1e-12);
  EXPECT_EQ(cellText(document, "learning-find-times", "Session 1", "gc / ppc"), "-");
  EXPECT_THAT(reasonsOf(document), Contains("Session 1, gc: no subject has such trials."));
  EXPECT_THAT(reasonsOf(document), Contains("Session 1, gc / ppc: no subject has such trials in both views."));

  SectionStudy untimed;
  untimed.add("S1", 1, kPpc, 0).correct = std::nullopt;
  EXPECT_THAT(reasonsOf(learningOf(untimed)),
              ElementsAre("Time to find (s): no trial has a value.", "Share found: no trial has a value."));
}

}  // namespace
}  // namespace ocelli::test
