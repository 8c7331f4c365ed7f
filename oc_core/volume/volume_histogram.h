// How often values stand in a volume: for those who edit transfer functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

/// Bins of equal width between the least and the greatest value of a volume, which are the outer bounds of the first
/// and the last bin; where whole numbers are counted one by one, the centres of these bins.
struct VolumeHistogram {
  ValueRange values{};             ///< the least and the greatest
  ValueRange bounds{};             ///< the lower bound of the first bin, and the upper one of the last
  std::vector<uint64_t> counts{};  ///< at least 1 bin

  uint64_t total() const;
  double binWidth() const { return (bounds.greatest - bounds.least) / double(counts.size()); }
};

/// Of all voxels that are finite numbers, on all threads. Volumes of whole numbers whose range is below 65536 have a
/// bin for each number, others have 4096. Of a volume larger than memory ask a level (volume_levels.h): this reads all.
VolumeHistogram histogramOf(const ScalarVolume& volume);

}  // namespace ocelli
