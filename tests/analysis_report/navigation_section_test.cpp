#include "analysis/report/navigation_section.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "analysis/dataset/database.h"
#include "analysis/report/report_task.h"
#include "tests/analysis_dataset/sample_study.h"
#include "tests/analysis_report/section_study.h"

namespace ocelli::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kEast = std::numbers::pi / 2;
constexpr double kFrame = 4 / 240.0;  // s
constexpr const char* kTable = "navigation-stationary";

/// The maze of the sample: cells of 2 m; location 1 in row 0, column 2, location 2 in row 1, column 2 behind a wall.
struct NavigationSection : ::testing::Test {
  void SetUp() override {
    for (const char* subject : {"S01", "S02"}) {
      study.addSubject(subject);
      study.addSession(subject, 1);
    }
  }
  /// From the middle of row 1, column 0 by four frames north, and then east by `steps` frames of half a metre.
  void addWalk(const SampleTrial& trial, int steps) {
    const int64_t id = study.addTrial(trial);
    int frame = 0;
    for (double z = 3; z > 1; z -= 0.5) {
      study.addFrame(id, frame++, 1, z, 0);
    }
    for (int step = 0; step <= steps; ++step) {
      study.addFrame(id, frame++, 1 + 0.5 * step, 1, kEast);
    }
  }
  /// Each subject searches once with each view; with gc it is found before any pinhole would show it.
  void addFourSearches() {
    for (const char* subject : {"S01", "S02"}) {
      SampleTrial trial;
      trial.subject = subject;
      trial.response = 1;
      addWalk(trial, subject[2] == '1' ? 2 : 4);
      trial.plan = 1;
      trial.view = "gc";
      trial.response = 2 * kFrame;
      const int64_t id = study.addTrial(trial);
      for (int frame = 0; frame < 3; ++frame) {
        study.addFrame(id, frame, 1, 3 - 0.5 * frame, 0);
      }
    }
  }
  ReportDocument document() const {
    return documentOf(applyPlan(readDatabase(path), defaultPlan()),
                      [](ReportWork& work) { addNavigationSection(work, reportTask("find")); });
  }

  SampleFolder folder;
  std::string path = folder.file("study.db");
  SampleStudy study{path};
};

TEST_F(NavigationSection, comparesWaysAndSightBySubject) {
  addFourSearches();
  const ReportDocument found = document();
  // 2 m to the north and 1 m or 2 m to the east; 1 m with gc.
  EXPECT_NEAR(*cellValue(found, kTable, "Way walked (m)", "ppc"), 3.5, 1e-12);
  EXPECT_EQ(cellText(found, kTable, "Way walked (m)", "gc"), "1.00");
  EXPECT_NEAR(*cellValue(found, kTable, "Way walked (m)", "gc less ppc"), -2.5, 1e-12);
  // Differences -2 and -3: error 0.5, t of 97.5 % with 1 degree 12.7062.
  EXPECT_EQ(cellText(found, kTable, "Way walked (m)", "gc less ppc"), "-2.5 (-8.9 to 3.9)");
  EXPECT_EQ(cellText(found, kTable, "Way walked (m)", "Subjects"), "2, 2, 2");
  EXPECT_THAT(originOf(found, "navigation-stationary/way-walked-m-ppc/estimate").rows,
              ElementsAre(RowRef{0, 1}, RowRef{0, 3}));
  // A quarter turn.
  EXPECT_EQ(cellText(found, kTable, "Turned, either way (full turns)", "ppc"), "0.250");
  // Straight sight with the fifth frame of ppc; with gc never: all of it is travel.
  EXPECT_NEAR(*cellValue(found, kTable, "Travel: before straight sight (s)", "ppc"), 4 * kFrame, 1e-12);
  EXPECT_NEAR(*cellValue(found, kTable, "Travel: before straight sight (s)", "gc"), 2 * kFrame, 1e-12);
  EXPECT_NEAR(*cellValue(found, kTable, "Detection: the rest (s)", "ppc"), 1 - 4 * kFrame, 1e-12);
  EXPECT_NEAR(*cellValue(found, kTable, "Detection: the rest (s)", "gc"), 0, 1e-12);
  EXPECT_EQ(cellText(found, kTable, "First straight sight, where there was one (s)", "gc"), "-");
  EXPECT_TRUE(hasFigure(found, "figure-navigation"));
  EXPECT_TRUE(hasFigure(found, "figure-heat-small-stationary"));
}

TEST_F(NavigationSection, travelAndDetectionMakeTheSearch) {
  addFourSearches();
  const ReportDocument found = document();
  for (const char* column : {"ppc", "gc", "gc less ppc"}) {
    EXPECT_NEAR(*cellValue(found, kTable, "Travel: before straight sight (s)", column) +
                    *cellValue(found, kTable, "Detection: the rest (s)", column),
                *cellValue(found, kTable, "Time searched (s)", column), 1e-12);
  }
}

TEST_F(NavigationSection, saysWhatBecameOfSearchesAndWhatIsNotKnown) {
  addFourSearches();
  SampleTrial trial;
  trial.plan = 2;
  trial.censored = true;
  trial.correct = false;
  addWalk(trial, 4);
  trial.plan = 3;
  trial.caseIndex = 1;  // behind the wall
  addWalk(trial, 4);
  const ReportDocument found = document();
  const std::string table = "navigation-outcomes";
  EXPECT_EQ(cellText(found, table, "In straight sight, then found", "ppc"), "2 (50.0 %)");
  EXPECT_EQ(cellText(found, table, "Found before it was in straight sight", "gc"), "2 (100.0 %)");
  EXPECT_EQ(cellText(found, table, "In straight sight, but time ran out", "ppc"), "1 (25.0 %)");
  EXPECT_EQ(cellText(found, table, "Never in straight sight, and time ran out", "ppc"), "1 (25.0 %)");
  EXPECT_EQ(cellText(found, "navigation-stationary-unknown", "First straight sight, where there was one (s)", "ppc"),
            "1");
  EXPECT_EQ(cellText(found, "navigation-stationary-unknown", "First straight sight, where there was one (s)", "gc"),
            "2");
  EXPECT_EQ(cellText(found, "navigation-stationary-medians", "Way walked (m)", "ppc searches"), "4");
  // 3, 4, 4, 4.
  EXPECT_EQ(*cellValue(found, "navigation-stationary-medians", "Way walked (m)", "ppc median"), 4);
}

TEST_F(NavigationSection, oneSubjectHasNoInterval) {
  addWalk({}, 4);
  const ReportDocument found = document();
  EXPECT_EQ(cellText(found, kTable, "Way walked (m)", "ppc"), "no such cell");
  EXPECT_THAT(reasonsOf(found), Contains(HasSubstr("only one subject has such trials")));
  EXPECT_THAT(reasonsOf(found), Contains(HasSubstr("no subject has such trials in both views")));
  EXPECT_EQ(cellText(found, "navigation-stationary-medians", "Way walked (m)", "gc searches"), "0");
}

TEST_F(NavigationSection, withoutLogsItSaysSo) {
  SampleTrial trial;
  trial.frames = 0;
  study.addTrial(trial);
  const ReportDocument found = document();
  EXPECT_THAT(reasonsOf(found), ElementsAre(HasSubstr("none of 1 searches has a log of where the subject stood")));
  EXPECT_EQ(found.elements.size(), 2u);
}

TEST_F(NavigationSection, withoutSearchesItSaysSo) {
  EXPECT_THAT(reasonsOf(document()), ElementsAre("Ways, sight and turns: there are no searches."));
}

}  // namespace
}  // namespace ocelli::test
