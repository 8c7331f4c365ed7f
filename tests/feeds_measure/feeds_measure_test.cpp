// The whole way: feeds are simulated, run and evaluated.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/feeds_measure/evaluate_feeds.h"
#include "oc_core/feeds_measure/feed_rigs.h"
#include "oc_core/feeds_measure/feed_truth.h"
#include "oc_core/feeds_measure/simulate_feeds.h"
#include "oc_core/feeds_measure/simulated_feed.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

constexpr const char* kCoarse = "builtin:corridor_t,texel=0.15";

FeedSimulationOptions shortOptions() {
  FeedSimulationOptions options;
  options.scene = kCoarse;
  options.seconds = 2;
  options.framesPerSecond = 15;
  options.walkers = 3;
  options.seed = 5;
  options.droppedShare = 0.1;
  return options;
}

TEST(FeedsMeasure, simulationFollowsItsSeed) {
  const test::TemporaryFolder folder;
  FeedSimulationOptions options = shortOptions();
  options.seconds = 0.6;
  options.maskEvery = 4;
  simulateFeeds(options, folder.path() / "a");
  simulateFeeds(options, folder.path() / "b");
  options.seed = 6;
  simulateFeeds(options, folder.path() / "c");
  for (const char* name : {"setup.json", "truth.json", "stem.png", "left.mkv", "masks/right-000004.png"}) {
    const std::string a = readFile(folder.path() / "a" / name);
    EXPECT_TRUE(a == readFile(folder.path() / "b" / name)) << name;
    EXPECT_FALSE(a == readFile(folder.path() / "c" / name)) << name;
  }
}

TEST(FeedsMeasure, masksAreWhereTheTruthPutsWalkers) {
  const FeedSetup setup = corridorTRig().setup();
  SceneOptions sceneOptions;
  sceneOptions.fit = false;
  sceneOptions.shading = Shading::kNone;
  const Mesh place = loadScene(kCoarse, sceneOptions);
  const Walkers walkers(corridorTRig().ways(), 1, 60, 3);
  const SimulatedFeed camera(setup.feeds[0], place);
  size_t seen = 0;
  for (double seconds = 0; seconds < 60; seconds += 1.5) {
    const WalkerMask mask = camera.mask(walkers, seconds);
    const glm::dvec2 p = walkers.at(0, seconds).place;
    const auto chest = feedPixelOf(setup.feeds[0], {p.x, 1.1, p.y});
    // In the stem or the crossing, before the camera, nothing hides it.
    if (std::abs(p.x) < 1 && p.y < 3 && chest && chest->x > 2 && chest->y > 2 && chest->x < 638 && chest->y < 478) {
      ++seen;
      EXPECT_EQ(mask(static_cast<int>(chest->x), static_cast<int>(chest->y)), 1) << seconds;
    }
  }
  EXPECT_GT(seen, 3u);
}

TEST(FeedsMeasure, aFrozenFeedHoldsNobodyUp) {
  const test::TemporaryFolder folder;
  FeedSimulationOptions options = shortOptions();
  options.frozenFeed = "left";
  options.frozenSeconds = 0.3;
  simulateFeeds(options, folder.path());
  FeedsRunOptions run;
  run.framesPerSecond = 15;
  run.streams.frozenSeconds = 0.5;
  size_t frames = 0;
  bool wasFrozen = false;
  Image<Rgb8> last;
  size_t changes = 0;
  const FeedsRunFigures figures =
      runFeeds(readFeedSetup(folder.path() / "setup.json"), run, [&](const ComposedFrame& frame) {
        ++frames;
        changes += !(frame.image == last);
        last = frame.image;
      });
  EXPECT_GE(frames, 28u);
  EXPECT_GE(changes, frames - 3) << "the other feeds go on";
  ASSERT_EQ(figures.feeds.size(), 3u);
  for (const FeedRunFigures& feed : figures.feeds) {
    wasFrozen = wasFrozen || feed.wasFrozen;
    EXPECT_EQ(feed.wasFrozen, feed.name == "left") << feed.name;
    EXPECT_EQ(feed.state, FeedState::kEnded);
  }
  EXPECT_TRUE(wasFrozen);
}

TEST(FeedsMeasure, aMissingFeedIsHatchedAndSaid) {
  const test::TemporaryFolder folder;
  FeedSimulationOptions options = shortOptions();
  options.seconds = 0.5;
  simulateFeeds(options, folder.path());
  std::filesystem::remove(folder.path() / "right.mkv");
  size_t frames = 0;
  const FeedsRunFigures figures =
      runFeeds(readFeedSetup(folder.path() / "setup.json"), {}, [&](const ComposedFrame&) { ++frames; });
  EXPECT_GT(frames, 5u);
  EXPECT_EQ(figures.feeds[2].state, FeedState::kLost);
  EXPECT_THAT(figures.feeds[2].message, testing::HasSubstr("right.mkv"));
}

TEST(FeedsMeasure, walkersAreSeenOnceForTheMostPart) {
  const test::TemporaryFolder folder;
  FeedSimulationOptions options = shortOptions();
  options.seconds = 4;
  simulateFeeds(options, folder.path());
  const FeedsEvaluation found = evaluateFeeds(folder.path(), {});
  EXPECT_GT(found.frames, 50u);
  EXPECT_GT(found.rightShare(), 0.98);  // 1 when this was written
  EXPECT_GT(found.possibleShare(), 0.97);
  EXPECT_GT(found.psnrDecibels, 18);
  // Another setup has other near faces, and the cameras are where they were.
  FeedSetup swapped = readFeedSetup(folder.path() / "setup.json");
  swapped.frusta.pop_back();
  writeFeedSetup(swapped, folder.path() / "two.json");
  FeedsEvaluationOptions two;
  two.setup = folder.path() / "two.json";
  two.seconds = 1;
  const FeedsEvaluation without = evaluateFeeds(folder.path(), two);
  EXPECT_GT(without.rightShare(), 0.9);
  // Without the memory of those who are hidden nothing is better than what cameras see.
  FeedsEvaluationOptions forgetful;
  forgetful.showsHidden = false;
  const FeedsEvaluation seen = evaluateFeeds(folder.path(), forgetful);
  EXPECT_EQ(seen.possibleShare(), found.possibleShare());
  EXPECT_GE(seen.possibleShare(), seen.rightShare());
  EXPECT_GT(seen.rightShare(), 0.94);  // 0.972 when this was written
  EXPECT_LT(seen.rightShare(), found.rightShare());
  // Without the backgrounds' subtraction walkers are doubled: what is measured can fail.
  FeedsEvaluationOptions blind;
  blind.backgrounds.minBlobPixels = 1e9;
  const FeedsEvaluation worse = evaluateFeeds(folder.path(), blind);
  EXPECT_LT(worse.rightShare(), found.rightShare());
  EXPECT_EQ(worse.possibleShare(), found.possibleShare()) << "what cameras see is the same";
}

TEST(FeedsMeasure, namesScenesWithoutCameras) {
  EXPECT_THROW(feedRigOf("builtin:bunny"), InputError);
  const test::TemporaryFolder folder;
  FeedSimulationOptions options = shortOptions();
  options.frozenFeed = "attic";
  EXPECT_THROW(simulateFeeds(options, folder.path()), InputError);
  EXPECT_THROW(evaluateFeeds(folder.path(), {}), InputError);
}

}  // namespace
}  // namespace ocelli
