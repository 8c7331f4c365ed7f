#include "display_driver/selftest/misbuilt_displays.h"

#include <gtest/gtest.h>

#include "display_driver/selftest/pattern_volumes.h"
#include "display_driver/selftest/test_patterns.h"
#include "tests/display_driver_selftest/pattern_profiles.h"

namespace ocelli {
namespace {

// An example that looks right would teach nothing. On the smallest displays some errors are less than a voxel.
TEST(MisbuiltDisplays, EveryExampleLooksWrong) {
  for (const DisplayProfile& profile : test::patternProfiles()) {
    for (const TestPattern& pattern : testPatterns()) {
      const Volume sent = pattern.volume(profile);
      for (const WrongLook& wrong : pattern.wrong) {
        if (wrong.shown == nullptr) {
          continue;
        }
        const Volume shown = wrong.shown(sent);
        EXPECT_EQ(shown.profile(), profile);
        if (profile.height > 2) {
          EXPECT_FALSE(shown == sent) << pattern.name << " " << profile.name << ": " << wrong.looks;
        }
      }
    }
  }
}

TEST(MisbuiltDisplays, ReversingTwiceIsRight) {
  for (const DisplayProfile& profile : test::patternProfiles()) {
    // A middle column is on both sides of the axis.
    if (profile.width % 2 != 0) {
      continue;
    }
    const Volume sent = orientationPattern(profile);
    for (const auto reversed : {slicesReversed, columnsReversed, slicesAndColumnsReversed, rowsReversed}) {
      EXPECT_EQ(reversed(reversed(sent)), sent) << profile.name;
    }
  }
}

/// Rings of the axis pattern in slice 5, on the equator, as columns from the middle of the screen.
std::vector<int> ringsOnTheEquator(const Volume& volume) {
  std::vector<int> rings;
  for (int column = volume.width() / 2 + 2; column < volume.width(); ++column) {
    if (volume.colorBits(5, column, volume.height() / 2) != 0) {
      rings.push_back(column - volume.width() / 2);
    }
  }
  return rings;
}

TEST(MisbuiltDisplays, AScreenBesideTheAxisDoublesRings) {
  const Volume sent = axisPattern(test::patternProfile(24, 120, 60));
  EXPECT_EQ(ringsOnTheEquator(sent), (std::vector<int>{15, 30, 45, 59}));
  // A fortieth of 120 columns to either side; the outermost ring of the one leaves the screen.
  EXPECT_EQ(ringsOnTheEquator(screenBesideAxis(sent)), (std::vector<int>{3, 12, 18, 27, 33, 42, 48, 56}));
}

TEST(MisbuiltDisplays, AStuckPixelDrawsAWholeCircle) {
  for (const SecondHalfTurn second : {SecondHalfTurn::kMirrored, SecondHalfTurn::kOwn}) {
    DisplayProfile profile = test::patternProfile(24, 120, 60);
    profile.secondHalfTurn = second;
    const Volume shown = pixelsStuck(darkPattern(profile));
    // Three pixels, in each of 48 sectors.
    EXPECT_EQ(shown.litVoxels(), 3u * 48u);
  }
}

}  // namespace
}  // namespace ocelli
