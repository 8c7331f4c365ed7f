#include "analysis/dataset/run_screen.h"

#include <gtest/gtest.h>

#include "analysis/dataset/database.h"
#include "analysis/dataset/merge.h"
#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

Run runWith(const std::string& environment, const std::string& check) {
  Run run;
  run.environment = environment;
  run.timingCheck = check;
  return run;
}

// As study/screen writes them.
constexpr const char* kEnvironment =
    R"({"graphics": {"renderer": "GeForce", "software": false}, "monitor": {"name": "U24", "width": 1920, "height": 1200,
        "refresh_hertz": 60, "width_millimeters": 518, "height_millimeters": 324}, "paced_hertz": null,
        "not_measured": ["latency of mouse and keyboard"]})";
constexpr const char* kCheck =
    R"({"verdict": "good", "measured": {"hertz": 59.95, "jitter_share": 0.004, "late_share": 0}})";

TEST(RunScreen, IsWhatTheRunStored) {
  const RunScreen screen = screenOf(runWith(kEnvironment, kCheck));
  EXPECT_FALSE(screen.simulated);
  EXPECT_EQ(screen.monitor, "U24");
  EXPECT_EQ(screen.widthPixels, 1920);
  EXPECT_EQ(screen.heightMillimeters, 324);
  EXPECT_EQ(screen.refreshHertz, 60);
  EXPECT_EQ(screen.graphics, "GeForce");
  EXPECT_FALSE(screen.pacedHertz);
  EXPECT_EQ(screen.verdict, "good");
  EXPECT_EQ(screen.measuredHertz, 59.95);
  EXPECT_EQ(screen.lateShare, 0);
  ASSERT_EQ(screen.notMeasured.size(), 1U);
}

TEST(RunScreen, OfOtherTextIsNotKnown) {
  for (const char* text : {"", "{}", "not JSON", "[1]", "null", R"({"monitor": 5, "measured": [], "verdict": {}})",
                           R"({"monitor": {"width": "wide", "refresh_hertz": null, "width_millimeters": 0}})"}) {
    const RunScreen screen = screenOf(runWith(text, text));
    EXPECT_FALSE(screen.widthPixels) << text;
    EXPECT_FALSE(screen.widthMillimeters) << text;
    EXPECT_FALSE(screen.refreshHertz) << text;
    EXPECT_EQ(screen.verdict, "") << text;
  }
}

TEST(RunScreen, ComesWithTheRunsOfADatabase) {
  SampleFolder folder;
  const std::string path = folder.file("study.db");
  {
    SampleStudy study(path);
    fillSmallStudy(study);
    study.database().exec("DROP TRIGGER run_update; DROP TRIGGER run_update_start");
    SQLite::Statement update(study.database(), "UPDATE run SET environment_json = ?, timing_check_json = ?");
    update.bind(1, kEnvironment);
    update.bind(2, kCheck);
    update.exec();
  }
  const Dataset data = merge({readDatabase(path), readDatabase(path)});
  ASSERT_EQ(data.runs.size(), 4U) << "two subjects with two sessions, once each";
  EXPECT_EQ(data.runs[0].subject, "S01");
  EXPECT_EQ(data.runs[0].station, "here");
  EXPECT_EQ(screenOf(data.runs[3]).monitor, "U24");
}

}  // namespace
}  // namespace ocelli::test
