#include "analysis/report/speed_accuracy_section.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/analysis_report/hand_made_trials.h"
#include "tests/analysis_report/section_study.h"

namespace ocelli::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

ReportDocument speedAccuracyOf(const SectionStudy& study, const std::vector<std::string>& tasks = {"count"}) {
  return documentOf(study.analysis, [&](ReportWork& work) { addSpeedAccuracySection(work, rowsOf(tasks)); });
}

/// Two subjects. With ppc each is right after 8 and 2 s and wrong after 4 s; with gc always right after 2 s.
SectionStudy answers() {
  SectionStudy study;
  for (const char* subject : {"S1", "S2"}) {
    study.add(subject, 1, kPpc, 8, true, "count");
    study.add(subject, 1, kPpc, 2, true, "count");
    study.add(subject, 1, kPpc, 4, false, "count");
    study.add(subject, 1, kGc, 2, true, "count");
  }
  return study;
}

TEST(SpeedAccuracySection, tellsTimesSharesAndTheirRatio) {
  SectionStudy study = answers();
  study.add("S1", 1, kGc, 8, true, "count");  // S1: geometric mean of 2 and 8
  const ReportDocument document = speedAccuracyOf(study);
  const std::string table = "speed-accuracy-count";
  // (8 * 2 * 4)^(1/3) = 4 of both subjects.
  EXPECT_NEAR(*cellValue(document, table, "ppc: time to answer (s)", "Estimate"), 4, 1e-12);
  EXPECT_NEAR(*cellValue(document, table, "ppc: share of right answers", "Estimate"), 2.0 / 3, 1e-12);
  // sqrt(4 * 2): each subject counts once.
  EXPECT_NEAR(*cellValue(document, table, "gc: time to answer (s)", "Estimate"), std::sqrt(8.0), 1e-12);
  EXPECT_NEAR(*cellValue(document, table, "gc: share of right answers", "Estimate"), 1, 1e-12);
  // Right ones take sqrt(8 * 2) = 4 s, wrong ones 4 s.
  EXPECT_NEAR(
      *cellValue(document, table, "ppc: time of right answers / of wrong ones (2 subjects with both)", "Estimate"), 1,
      1e-12);
  EXPECT_THAT(reasonsOf(document), Contains(HasSubstr("fewer than two subjects have both right and wrong answers")));
  EXPECT_TRUE(hasFigure(document, "figure-speed-accuracy-count"));
}

TEST(SpeedAccuracySection, leavesOutWhatHasNoAnswer) {
  SectionStudy study = answers();
  study.add("S1", 1, kPpc, 30, false, "count").censored = true;
  const ReportDocument document = speedAccuracyOf(study);
  EXPECT_NEAR(*cellValue(document, "speed-accuracy-count", "ppc: time to answer (s)", "Estimate"), 4, 1e-12);
}

TEST(SpeedAccuracySection, isNotOfTasksWhoseOutcomeIsTheTime) {
  const ReportDocument document = speedAccuracyOf(answers(), {"find"});
  EXPECT_TRUE(document.elements.empty());
}

TEST(SpeedAccuracySection, saysWhatItLacks) {
  SectionStudy study;
  const ReportDocument document = speedAccuracyOf(study);
  EXPECT_THAT(reasonsOf(document), Contains(HasSubstr("no trial has both a time and an answer")));
}

}  // namespace
}  // namespace ocelli::test
