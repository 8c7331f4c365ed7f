// A blue-noise mask in three dimensions: the order in which voxels are lit as the light rises, such that those lit lie
// as far from each other as they can at any light.
//
// Source: R. Ulichney, "The void-and-cluster method for dither array generation" (1993), here with a Gaussian over
// three dimensions that wrap around. Blue are the blocks of a volume; a surface that cuts them meets noise that is
// nearly white, since what is left out next to a lit voxel lies mostly off the surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ocelli {

/// The mask repeats after so many columns, rows and slices.
inline constexpr int kBlueNoiseSide = 32;
inline constexpr int kBlueNoiseRanks = kBlueNoiseSide * kBlueNoiseSide * kBlueNoiseSide;

/// Each of 0 to kBlueNoiseRanks - 1 once; columns of a row lie together, then rows, then slices. The first call makes
/// it, in about a fifth of a second.
const std::vector<uint16_t>& blueNoiseMask();

/// Where a voxel lies in the mask.
inline size_t blueNoisePlace(int slice, int column, int row) {
  constexpr auto kMask = static_cast<unsigned>(kBlueNoiseSide - 1);
  return ((static_cast<unsigned>(slice) & kMask) * kBlueNoiseSide + (static_cast<unsigned>(row) & kMask)) *
             kBlueNoiseSide +
         (static_cast<unsigned>(column) & kMask);
}

}  // namespace ocelli
