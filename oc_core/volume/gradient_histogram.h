// How often a value and a length of the gradient come together in a volume: the arcs in it are the boundaries between
// materials (G. Kindlmann and J. Durkin, "Semi-automatic generation of transfer functions for direct volume
// rendering", 1998).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

struct GradientHistogram {
  ValueRange values{};             ///< the bounds of all columns
  double maxGradient = 0;          ///< the upper bound of the last row, by the world's unit of length; rows start at 0
  size_t columns = 0;              ///< bins of values
  size_t rows = 0;                 ///< bins of gradients
  std::vector<uint64_t> counts{};  ///< values fastest
};

/// Of all voxels, or, where there are more than kMaxGradientVoxels, of every n-th along i, j and k. On all threads; the
/// result is the same with any number of them. Voxels are numbers: not NaN.
inline constexpr size_t kMaxGradientVoxels = size_t{1} << 22U;
GradientHistogram gradientHistogramOf(const ScalarVolume& volume, size_t columns, size_t rows);

}  // namespace ocelli
