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
  // Nothing covered yet: since the first picture.
  shown = shownViews({-1, 1, 2, 3, 4});
  for (size_t k = 1; k < 5; ++k) {
    shown[k].isCovered = false;
  }
  EXPECT_NEAR(lagsOf(path, shown)[4], 0.3, 1e-12);
}

TEST(Playback, stallsWhereItLagsFor) {
  const RemotePath path = turningPath(12, 10);
  //                                       lags   0  .1  .2  .3   0  .1   0  .2  .1  .2  .2   0
  const std::vector<ShownView> shown = shownViews({0, 0, 0, 0, 4, 4, 6, 5, 7, 7, 8, 11});
  const StallFigures stalls = stallsOf(path, shown, false);
  EXPECT_EQ(stalls.count, 3u);
  EXPECT_NEAR(stalls.longestSeconds, 0.2, 1e-12);
  EXPECT_NEAR(stalls.totalSeconds, 0.5, 1e-12);
}

TEST(Playback, doesNotStallWhileCoveredWhereItIsNot) {
  const RemotePath path = turningPath(6, 10);
  std::vector<ShownView> shown = shownViews({0, 1, 2, 3, 4, 5});
  for (const size_t k : {1, 2, 3}) {
    shown[k].isCovered = false;
  }
  EXPECT_EQ(stallsOf(path, shown, true).count, 0u);
  // Its lags are 0.1, 0.2 and 0.3 s: two of them are too long.
  EXPECT_NEAR(stallsOf(path, shown, false).longestSeconds, 0.2, 1e-12);
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
