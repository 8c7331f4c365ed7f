#include "oc_core/remote_measure/playback.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/remote_measure/measured_paths.h"

namespace ocelli {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

// 10 frames a second: each frame is 0.1 s.
TEST(Playback, lagsBehindByTheAgeOfTheViewShown) {
  const RemotePath path = turningPath(6, 10);
  const auto near = [](double value) { return DoubleNear(value, 1e-12); };
  EXPECT_THAT(lagsOf(path, shownViews({-1, 0, 0, 2, 4, 5})),
              ElementsAre(near(0), near(0.1), near(0.2), near(0.1), near(0), near(0)));
}

TEST(Playback, doesNotLagWhereTheViewRests) {
  RemotePath path = turningPath(4, 10);
  path.views[2] = path.views[1];
  path.views[3] = path.views[1];
  EXPECT_THAT(lagsOf(path, shownViews({0, 1, 1, 1})), ElementsAre(0, 0, 0, 0));
}

TEST(Playback, lagsSinceItWasCoveredLast) {
  const RemotePath path = turningPath(5, 10);
  std::vector<ShownView> shown = shownViews({0, 1, 2, 3, 4});
  shown[2].isCovered = false;
  shown[3].isCovered = false;
  const std::vector<double> lags = lagsOf(path, shown);
  EXPECT_NEAR(lags[1], 0, 1e-12);
  EXPECT_NEAR(lags[2], 0.1, 1e-12);
  EXPECT_NEAR(lags[3], 0.2, 1e-12);
  EXPECT_NEAR(lags[4], 0, 1e-12);
  // Nothing covered yet: since the path began.
  shown = shownViews({-1, 1, 2, 3, 4});
  for (size_t k = 1; k < 5; ++k) {
    shown[k].isCovered = false;
  }
  EXPECT_NEAR(lagsOf(path, shown)[4], 0.4, 1e-12);
}

TEST(Playback, stallsWhereNothingElseComes) {
  const RemotePath path = turningPath(12, 10);
  // Frame 0 stays for 0.4 s, 4 and 7 for 0.2 s.
  const std::vector<ShownView> shown = shownViews({0, 0, 0, 0, 4, 4, 6, 5, 7, 7, 8, 11});
  const StallFigures stalls = stallsOf(path, shown, false);
  EXPECT_EQ(stalls.count, 3u);
  EXPECT_NEAR(stalls.longestSeconds, 0.4, 1e-12);
  EXPECT_NEAR(stalls.totalSeconds, 0.8, 1e-12);
}

// A round trip of 0.3 s is a lag; a stall is but the wait for the first picture.
TEST(Playback, doesNotStallWhereFramesComeLateButOnAndOn) {
  const RemotePath path = turningPath(8, 10);
  const std::vector<ShownView> shown = shownViews({-1, -1, -1, 0, 1, 2, 3, 4});
  EXPECT_NEAR(lagsOf(path, shown)[7], 0.3, 1e-12);
  const StallFigures stalls = stallsOf(path, shown, false);
  EXPECT_EQ(stalls.count, 1u);
  EXPECT_NEAR(stalls.totalSeconds, 0.3, 1e-12);
  EXPECT_EQ(stallsOf(path, shown, true).count, 0u);
}

TEST(Playback, stallsFromBeginningToEndWhereNothingComes) {
  const RemotePath path = turningPath(5, 10);
  const std::vector<ShownView> shown = shownViews({-1, -1, -1, -1, -1});
  EXPECT_NEAR(stallsOf(path, shown, false).longestSeconds, 0.5, 1e-12);
  EXPECT_NEAR(lagsOf(path, shown)[4], 0.4, 1e-12);
}

TEST(Playback, doesNotStallWhereTheViewRests) {
  RemotePath path = turningPath(6, 10);
  for (size_t k = 2; k < 6; ++k) {
    path.views[k] = path.views[1];
  }
  EXPECT_EQ(stallsOf(path, shownViews({0, 1, 1, 1, 1, 1}), false).count, 0u);
  // It does where the view that rests has not come.
  EXPECT_NEAR(stallsOf(path, shownViews({0, 0, 0, 0, 1, 1}), false).totalSeconds, 0.4, 1e-12);
}

TEST(Playback, doesNotStallWhileCoveredWhereItIsNot) {
  const RemotePath path = turningPath(6, 10);
  std::vector<ShownView> shown = shownViews({0, 1, 2, 3, 4, 5});
  for (const size_t k : {1, 2, 3}) {
    shown[k].isCovered = false;
  }
  EXPECT_EQ(stallsOf(path, shown, true).count, 0u);
  // From the first frame, which is covered, to the fifth.
  EXPECT_NEAR(stallsOf(path, shown, false).longestSeconds, 0.4, 1e-12);
  EXPECT_NEAR(coveredShare(shown), 0.5, 1e-12);
}

TEST(Playback, countsDifferentViews) {
  const RemotePath path = turningPath(10, 10);
  EXPECT_NEAR(viewsPerSecond(path, shownViews({-1, -1, 0, 0, 0, 3, 3, 5, 5, 5})), 3, 1e-12);
  EXPECT_EQ(viewsPerSecond(path, shownViews({-1, -1, -1, -1, -1, -1, -1, -1, -1, -1})), 0);
  EXPECT_EQ(coveredShare({ShownView{}}), 0);
}

}  // namespace
}  // namespace ocelli
