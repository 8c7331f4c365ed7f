#include "display_sim/dither/dither.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace ocelli {
namespace {

constexpr int kBlockColumns = 8;
constexpr int kBlockRows = 8;
constexpr int kBlockSlices = 4;

/// Of the block whose first voxel is given, ascending.
std::vector<double> sortedThresholds(int slice, int column, int row) {
  std::vector<double> thresholds;
  for (int s = 0; s < kBlockSlices; ++s) {
    for (int y = 0; y < kBlockRows; ++y) {
      for (int x = 0; x < kBlockColumns; ++x) {
        thresholds.push_back(ditherThreshold(slice + s, column + x, row + y));
      }
    }
  }
  std::ranges::sort(thresholds);
  return thresholds;
}

// The figures of dither.h. That blocks differ by their offset in a lattice of all thresholds alone makes some thousands
// of offsets enough.
TEST(Dither, everyBlockSpreadsItsThresholdsEvenly) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> place(0, 4095);
  double sum = 0;
  constexpr int kBlocks = 2000;
  constexpr int kLights = 1000;
  for (int block = 0; block < kBlocks; ++block) {
    const std::vector<double> thresholds = sortedThresholds(place(random), place(random), place(random));
    for (size_t i = 0; i < thresholds.size(); ++i) {
      ASSERT_NEAR(256 * thresholds[i], static_cast<double>(i) + 0.5, 1.6);
    }
    for (int i = 0; i < kLights; ++i) {
      const double light = (i + 0.5) / kLights;
      const auto lit = std::ranges::lower_bound(thresholds, light) - thresholds.begin();
      sum += std::abs(static_cast<double>(lit) / 256 - light);
    }
  }
  EXPECT_LT(sum / (kBlocks * kLights), 0.5 / 255);
}

// Near the axis voxels of consecutive slices lie at one place: their thresholds must be spread evenly by themselves. A
// lattice strays from an even spread by O(log n) / n; measured over many places, by 2.7 / n at most for these n.
TEST(Dither, consecutiveSlicesOfOnePlaceSpreadTheirThresholds) {
  for (const int count : {4, 8, 16, 32, 64, 198}) {
    for (int first = 0; first < 396; ++first) {
      std::vector<double> thresholds;
      for (int i = 0; i < count; ++i) {
        thresholds.push_back(ditherThreshold(first + i, 383, 100));
      }
      std::ranges::sort(thresholds);
      for (int i = 0; i < count; ++i) {
        ASSERT_NEAR(thresholds[static_cast<size_t>(i)], (i + 0.5) / count, 3.0 / count);
      }
    }
  }
}

TEST(Dither, fullLightIsAlwaysLitAndNoneNever) {
  for (int bits = 1; bits <= 8; ++bits) {
    const int full = (1 << bits) - 1;
    for (int slice = 0; slice < 8; ++slice) {
      for (int row = 0; row < 64; ++row) {
        for (int column = 0; column < 64; ++column) {
          const Rgb8 levels = ditheredLevels({1, 0, 2}, full, slice, column, row);
          ASSERT_EQ(levels, Rgb8(full, 0, full));
        }
      }
    }
  }
  // Whatever the sum, the threshold lies strictly between 0 and 1.
  EXPECT_GT((static_cast<float>(0u) + 0.5f) * 0x1p-23f, 0.0f);
  EXPECT_LT((static_cast<float>(~0u >> 9) + 0.5f) * 0x1p-23f, 1.0f);
}

TEST(Dither, aLevelOfTheDisplayIsShownAsItIs) {
  for (int bits = 1; bits <= 8; ++bits) {
    const int full = (1 << bits) - 1;
    for (int level = 0; level <= full; ++level) {
      const float light = static_cast<float>(level) / static_cast<float>(full);
      const int shown = ditheredLevel(light, full, 0.5f);
      EXPECT_EQ(shown, level) << bits;
    }
  }
}

}  // namespace
}  // namespace ocelli
