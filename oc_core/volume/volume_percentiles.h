// Values that shares of a volume's voxels lie below.
#pragma once

#include <span>
#include <vector>

#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

/// For each of `percents` (0 to 100) the least value of a voxel such that this share of all voxels has it or a lesser
/// one: exact, whatever the range is; of voxels that are finite numbers, and 0 where there are none. On all threads;
/// reads all voxels once for each 11 bits of their type, so of a volume larger than memory ask a level
/// (volume_levels.h).
std::vector<double> percentilesOf(const ScalarVolume& volume, std::span<const double> percents);

}  // namespace ocelli
