#include "display_sim/dither/blue_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <numbers>
#include <numeric>

namespace ocelli {
namespace {

TEST(BlueNoise, givesEachRankOnce) {
  std::vector<uint16_t> ranks = blueNoiseMask();
  std::ranges::sort(ranks);
  std::vector<uint16_t> all(kBlueNoiseRanks);
  std::iota(all.begin(), all.end(), uint16_t{0});
  EXPECT_EQ(ranks, all);
}

TEST(BlueNoise, repeatsAfterItsSide) {
  for (const int k : {1, 2, 24}) {
    EXPECT_EQ(blueNoisePlace(3 + k * kBlueNoiseSide, 5, 7), blueNoisePlace(3, 5, 7));
    EXPECT_EQ(blueNoisePlace(3, 5 + k * kBlueNoiseSide, 7), blueNoisePlace(3, 5, 7));
    EXPECT_EQ(blueNoisePlace(3, 5, 7 + k * kBlueNoiseSide), blueNoisePlace(3, 5, 7));
  }
}

/// Of the places below a rank, at a number of waves along columns, rows and slices; 1 for white noise.
double power(int belowRank, int columnWaves, int rowWaves, int sliceWaves) {
  std::complex<double> sum = 0;
  for (int slice = 0; slice < kBlueNoiseSide; ++slice) {
    for (int row = 0; row < kBlueNoiseSide; ++row) {
      for (int column = 0; column < kBlueNoiseSide; ++column) {
        if (blueNoiseMask()[blueNoisePlace(slice, column, row)] < belowRank) {
          const double turns = (columnWaves * column + rowWaves * row + sliceWaves * slice) % kBlueNoiseSide;
          sum += std::polar(1.0, 2 * std::numbers::pi * turns / kBlueNoiseSide);
        }
      }
    }
  }
  const double light = static_cast<double>(belowRank) / kBlueNoiseRanks;
  return std::norm(sum) / (kBlueNoiseRanks * light * (1 - light));
}

// White noise has power 1 on average. Blue noise has next to none at waves longer than the distance of its points,
// which at these lights is below 2.2 voxels; a twentieth is far from both.
TEST(BlueNoise, hasNoLongWaves) {
  for (const int rank : {kBlueNoiseRanks / 8, kBlueNoiseRanks / 2, 7 * kBlueNoiseRanks / 8}) {
    for (const int waves : {1, 2, 3, 4}) {  // of 32 to 8 voxels
      EXPECT_LT(power(rank, waves, 0, 0), 0.05);
      EXPECT_LT(power(rank, 0, waves, 0), 0.05);
      EXPECT_LT(power(rank, 0, 0, waves), 0.05);
      EXPECT_LT(power(rank, waves, -waves, 1), 0.05);
    }
  }
}

}  // namespace
}  // namespace ocelli
