// What voxel_resampler.h says, cell by cell and voxel by voxel.
#pragma once

#include <cstdint>
#include <vector>

#include "display_driver/devices/voxel_grid.h"
#include "display_sim/frames/volume.h"

namespace ocelli::test {

std::vector<uint8_t> slowlyResampled(const Volume& volume, const VoxelGrid& grid, int shownBits);

}  // namespace ocelli::test
