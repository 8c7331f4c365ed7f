// What all voxels of a volume tell in one reading: their range, and whether they are numbers at all.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <string>

#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

struct VoxelSurvey {
  ValueRange range{};            ///< of the finite ones; 0 to 0 where there are none
  ValueRange stored{};           ///< the same as voxels hold it, before scale and offset
  size_t notFinite = 0;          ///< voxels that are NaN or infinite
  glm::ivec3 firstNotFinite{0};  ///< the first of them in memory
};

/// Reads all voxels once, on all threads; holes of sparse files are not read.
VoxelSurvey surveyVoxels(const ScalarVolume& volume);

/// Throws InputError that says how many voxels are no finite numbers and where the first is, unless there are none.
/// `where` is the file; `factor` is that of the level (volume_levels.h) that was surveyed.
void requireFinite(const VoxelSurvey& survey, const std::string& where, int factor = 1);

}  // namespace ocelli
