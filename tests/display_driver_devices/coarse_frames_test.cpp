#include "display_driver/devices/coarse_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli {
namespace {

TEST(CoarseFrames, becomeTheWholeFrame) {
  const Volume volume = madeVolume(smallProfile(16), 3, 0.2);
  const std::vector<CoarseFrame> frames = coarseFrames(volume, std::array{0.25, 0.5, 1.0});
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames[0].slices, 4);
  EXPECT_EQ(frames[1].slices, 8);
  EXPECT_TRUE(frames[2].shown == volume);
  EXPECT_LT(frames[0].bytes, frames[1].bytes);
  EXPECT_LT(frames[1].bytes, frames[2].bytes);
  for (int i = 0; i < 16; ++i) {
    const int nearest = std::min(4 * ((i + 1) / 4), 12);
    EXPECT_TRUE(std::ranges::equal(frames[0].shown.slice(i), volume.slice(nearest))) << i;
  }
}

TEST(CoarseFrames, aDarkVolumeIsWhole) {
  const Volume dark(smallProfile());
  const std::vector<CoarseFrame> frames = coarseFrames(dark, std::array{0.1});
  EXPECT_TRUE(frames.front().shown == dark);
  EXPECT_EQ(frames.front().slices, 0);
}

}  // namespace
}  // namespace ocelli
