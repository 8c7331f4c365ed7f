// The study counts metres and degrees while it runs, 240 times a second; the log has the frames alone.
#include <gtest/gtest.h>

#include <numbers>

#include "analysis/dataset/database.h"
#include "analysis/measures/navigation.h"
#include "study/protocol/protocol.h"
#include "study/subject/simulate_study.h"
#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

TEST(ObservedWalks, areAsLongAsTheStudyCounts) {
  const SampleFolder folder;
  const std::string path = folder.file("observed.db");
  SimulationPlan plan;
  plan.sessions = {1};
  plan.seed = 3;
  plan.screen = {320, 200, 60};
  simulateStudy(readProtocol(OCELLI_SOURCE_DIR "/protocols/short.json"), path, plan);
  const Dataset data = readDatabase(path);
  const NavigationData navigation = navigationOf(data, "find");
  ASSERT_EQ(navigation.searches.size(), 6u);
  EXPECT_EQ(navigation.searchesWithoutLog, 0);
  for (const SearchNavigation& search : navigation.searches) {
    const Trial& trial = data.trials[search.trial];
    // Between two frames lie four steps, over which one may cut a corner or turn back: a hundredth.
    const double meters = trial.measures.at("path_length_m");
    const double degrees = trial.measures.at("turned_degrees");
    EXPECT_NEAR(search.walk.pathMeters, meters, 0.01 * meters + 0.1) << trial.trialId;
    EXPECT_NEAR(search.walk.turnedRadians * 180 / std::numbers::pi, degrees, 0.01 * degrees + 3) << trial.trialId;
    if (search.detectionSeconds) {
      EXPECT_GE(*search.detectionSeconds, 0);
      EXPECT_NEAR(*search.travelSeconds + *search.detectionSeconds, *trial.responseSeconds, 1e-9);
    }
    // With the pinhole what was clicked on was in sight.
    const bool foundByPinhole = trial.view == TrialView::kReference && !*trial.censored && !*trial.moving;
    EXPECT_TRUE(!foundByPinhole || search.travelSeconds) << trial.trialId;
    if (search.detour) {
      EXPECT_GT(*search.detour, 0.8) << trial.trialId;
    }
  }
}

}  // namespace
}  // namespace ocelli::test
