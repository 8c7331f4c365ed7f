#include "display_driver/selftest/test_patterns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "tests/display_driver_selftest/pattern_profiles.h"

namespace ocelli {
namespace {

TEST(TestPatterns, SayWhatTheyAreFor) {
  std::set<std::string> names;
  for (const TestPattern& pattern : testPatterns()) {
    EXPECT_TRUE(names.insert(pattern.name).second) << pattern.name;
    EXPECT_TRUE(std::regex_match(pattern.name, std::regex("[a-z]+"))) << pattern.name;
    EXPECT_FALSE(pattern.title.empty() || pattern.shows.empty() || pattern.lookFor.empty()) << pattern.name;
    EXPECT_GE(pattern.wrong.size(), 2u) << pattern.name;
    for (const WrongLook& wrong : pattern.wrong) {
      EXPECT_FALSE(wrong.looks.empty() || wrong.means.empty() || wrong.adjust.empty()) << pattern.name;
    }
    EXPECT_EQ(&testPattern(pattern.name), &pattern);
  }
}

TEST(TestPatterns, AnUnknownNameIsAnsweredWithThoseThatThereAre) {
  try {
    testPattern("spiral");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("spiral"), testing::HasSubstr("stairs")));
  }
}

TEST(TestPatterns, SuitEveryDisplay) {
  for (const DisplayProfile& profile : test::patternProfiles()) {
    for (const TestPattern& pattern : testPatterns()) {
      const Volume volume = pattern.volume(profile);
      EXPECT_EQ(volume.profile(), profile);
      if (profile.height > 2) {
        EXPECT_EQ(volume.litVoxels() == 0, pattern.name == "dark") << pattern.name << " " << profile.name;
      }
      for (const std::string& figure : pattern.figures(profile)) {
        EXPECT_THAT(figure, testing::AllOf(testing::HasSubstr("."), testing::Not(testing::HasSubstr("nan")),
                                           testing::Not(testing::HasSubstr("inf"))))
            << pattern.name;
      }
    }
  }
}

// Voxel (i + N, W - 1 - x) lies where voxel (i, x) does: both half turns must light the same places.
TEST(TestPatterns, OwnHalfTurnsShowTheSamePlaces) {
  for (const DisplayProfile& profile : test::patternProfiles()) {
    if (profile.secondHalfTurn != SecondHalfTurn::kOwn) {
      continue;
    }
    for (const TestPattern& pattern : testPatterns()) {
      const Volume volume = pattern.volume(profile);
      size_t different = 0;
      for (int slice = 0; slice < profile.slicesPerHalfTurn; ++slice) {
        for (int row = 0; row < profile.height; ++row) {
          for (int column = 0; column < profile.width; ++column) {
            // The middle column of an odd number is on both sides of the axis: it belongs to two sectors.
            if (2 * column + 1 == profile.width) {
              continue;
            }
            const unsigned first = volume.colorBits(slice, column, row);
            const unsigned second =
                volume.colorBits(slice + profile.slicesPerHalfTurn, profile.width - 1 - column, row);
            different += pattern.name == "phase" ? (first == 1) != (second == 6) : first != second;
          }
        }
      }
      EXPECT_EQ(different, 0u) << pattern.name << " " << profile.name;
    }
  }
}

TEST(TestPatterns, AreTheSameWithAnyNumberOfThreads) {
  const DisplayProfile profile = test::patternProfile(36, 90, 70);
  for (const TestPattern& pattern : testPatterns()) {
    const Volume all = pattern.volume(profile);
    setThreadCount(1);
    EXPECT_EQ(pattern.volume(profile), all) << pattern.name;
    setThreadCount(0);
  }
}

}  // namespace
}  // namespace ocelli
