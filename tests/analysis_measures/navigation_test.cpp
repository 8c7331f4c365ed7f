#include "analysis/measures/navigation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "analysis/dataset/database.h"
#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

using ::testing::HasSubstr;

constexpr double kEast = std::numbers::pi / 2;

/// The maze of the sample: cells of 2 m, the object of location 1 in row 0, column 2; location 2 in row 1, column 2.
struct Navigation : ::testing::Test {
  void SetUp() override {
    study.addSubject("S01");
    study.addSession("S01", 1);
  }
  /// From the middle of row 1, column 0 north, then east to the middle of the upper row; half a metre a frame.
  void addWalk(const SampleTrial& trial) {
    const int64_t id = study.addTrial(trial);
    int frame = 0;
    for (double z = 3; z > 1; z -= 0.5) {
      study.addFrame(id, frame++, 1, z, 0);
    }
    for (double x = 1; x <= 3; x += 0.5) {
      study.addFrame(id, frame++, x, 1, kEast);
    }
  }

  SampleFolder folder;
  std::string path = folder.file("study.db");
  SampleStudy study{path};
};

TEST_F(Navigation, measuresAWalk) {
  SampleTrial trial;
  trial.response = 1;
  addWalk(trial);
  const NavigationData data = navigationOf(readDatabase(path), "find");
  ASSERT_EQ(data.searches.size(), 1u);
  const SearchNavigation& search = data.searches[0];
  EXPECT_NEAR(search.walk.pathMeters, 4, 1e-12);
  EXPECT_NEAR(search.walk.turnedRadians, kEast, 1e-12);
  EXPECT_EQ(*search.shortestToEndMeters, 4.0);
  EXPECT_NEAR(*search.detour, 1, 1e-12);
  EXPECT_EQ(*search.shortestToObjectMeters, 6.0);
  EXPECT_NEAR(*search.walkedOverWayToObject, 4.0 / 6, 1e-12);
  EXPECT_NEAR(*search.travelSeconds, 4 * 4 / 240.0, 1e-12);  // the fifth frame looks east
  EXPECT_NEAR(*search.detectionSeconds, 1 - 16 / 240.0, 1e-12);
  ASSERT_EQ(data.heatMaps.size(), 1u);
  const MazeHeatMap& map = data.heatMaps[0];
  EXPECT_EQ(map.rows * map.columns, 6);
  // Three frames in the lower cell, the fourth at 1.5 m and four more in the upper one, until 3 m is reached.
  EXPECT_NEAR(map.seconds[3], 3 * 4 / 240.0, 1e-12);
  EXPECT_NEAR(map.seconds[0], 3 * 4 / 240.0, 1e-12);
  EXPECT_NEAR(map.seconds[1], 2 * 4 / 240.0, 1e-12);
  EXPECT_EQ(map.trials, 1);
  EXPECT_EQ(data.searchesWithoutLog, 0);
}

TEST_F(Navigation, saysWhatIsNotKnown) {
  SampleTrial trial;
  trial.caseIndex = 1;  // behind a wall
  trial.censored = true;
  addWalk(trial);
  trial.plan = 1;
  trial.caseIndex = 99;
  addWalk(trial);
  trial.plan = 2;
  trial.frames = 0;
  study.addTrial(trial);
  const NavigationData data = navigationOf(readDatabase(path), "find");
  ASSERT_EQ(data.searches.size(), 2u);
  EXPECT_FALSE(data.searches[0].travelSeconds);
  EXPECT_TRUE(data.searches[0].objectIsKnown);
  EXPECT_FALSE(data.searches[1].objectIsKnown);
  EXPECT_EQ(data.searches[0].travelSeconds.reason(), "the object never came into straight sight");
  EXPECT_EQ(*data.searches[0].shortestToObjectMeters, 8.0);
  EXPECT_EQ(data.searches[1].shortestToObjectMeters.reason(), "the protocol does not tell where the object stands");
  EXPECT_EQ(data.searchesWithoutLog, 1);
  EXPECT_THAT(data.notes[0], HasSubstr("1 search has no log"));
}

TEST_F(Navigation, timeOutsHaveNoDetection) {
  SampleTrial trial;
  trial.censored = true;
  addWalk(trial);
  const NavigationData data = navigationOf(readDatabase(path), "find");
  EXPECT_TRUE(data.searches[0].travelSeconds);
  EXPECT_EQ(data.searches[0].detectionSeconds.reason(), "time ran out");
}

TEST_F(Navigation, aLogOutsideOfTheMazeIsSaidToBe) {
  const int64_t id = study.addTrial({});
  study.addFrame(id, 0, -100, 1, 0);
  study.addFrame(id, 1, -100, 1e300, 0);
  const NavigationData data = navigationOf(readDatabase(path), "find");
  EXPECT_EQ(data.searches[0].detour.reason(), "the log leaves the maze");
  EXPECT_NEAR(data.heatMaps[0].secondsOutside, 4 / 240.0, 1e-12);
}

TEST_F(Navigation, aMovingObjectIsNowhereInTheLog) {
  const SampleFolder other;
  std::string protocol = kSampleProtocol;
  protocol.replace(protocol.find("\"limit_seconds\""), 0, "\"moving\": {\"meters_per_second\": 1}, ");
  SampleStudy moving(other.file("moving.db"), protocol);
  moving.addSubject("S01");
  moving.addSession("S01", 1);
  SampleTrial trial;
  trial.moving = true;
  const int64_t id = moving.addTrial(trial);
  moving.addFrame(id, 0, 1, 1, 0);
  moving.addFrame(id, 1, 1, 1, 0);
  const NavigationData data = navigationOf(readDatabase(other.file("moving.db")), "find");
  EXPECT_EQ(data.searches[0].travelSeconds.reason(), "the log does not tell where a moving object was");
  EXPECT_EQ(data.searches[0].detour.reason(), "the search ended in the cell where it began");
}

TEST_F(Navigation, nothingToReadIsNoError) {
  const NavigationData data = navigationOf(readDatabase(path), "find");
  EXPECT_TRUE(data.searches.empty());
  EXPECT_TRUE(data.notes.empty());
}

}  // namespace
}  // namespace ocelli::test
