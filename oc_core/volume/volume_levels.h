// Coarser volumes that stand for one that is too large: to be drawn at once, or within a budget of memory.
//
// A voxel of a level of factor f stands for f x f x f voxels of the whole, fewer at the upper faces where f does not
// divide the size: there the box of the level reaches out of that of the whole, by less than one voxel of the level.
// Levels have the facts of the whole, and its type, scale and offset but where a function says otherwise.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>

#include "oc_core/base/progress.h"
#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

struct VolumeLevel {
  std::shared_ptr<const ScalarVolume> volume;
  int factor = 1;
  /// Whether its voxels are single ones of the whole instead of means: what is thinner than `factor` may be missing.
  bool isSampled = false;
};

/// The least factor whose level has at most so many voxels, which are at least 1.
int levelFactor(const glm::ivec3& size, size_t maxVoxels);

/// From index coordinates of a level to those of the whole. Factors are by axis, here and below, and at least 1.
glm::dmat4 wholeFromLevelIndex(const glm::ivec3& factor);
/// The grid of a level: its world is that of the whole.
VolumeGrid levelGrid(const VolumeGrid& whole, const glm::ivec3& factor);

/// Each voxel is the mean of those that it stands for, rounded where the type is one of whole numbers. Reads all voxels
/// but the holes of sparse files, some 128 MiB at a time: the memory of a mapped volume is given back on the way. On
/// all threads, the same with any number of them. Voxels that are no numbers spread: ask surveyVoxels().
ScalarVolume averagedLevel(const ScalarVolume& whole, int factor, const Progress& progress = {});

/// The same in 16 bits of `range`, and not in the type of the whole: values beyond it count as its ends.
ScalarVolume averagedInRange(const ScalarVolume& whole, const glm::ivec3& factor, const ValueRange& range,
                             const Progress& progress = {});

/// Each voxel is the one in the middle of those that it stands for. Reads one row of `factor` x `factor`: what a first
/// look at a volume on a disk takes.
ScalarVolume sampledLevel(const ScalarVolume& whole, int factor, const Progress& progress = {});

/// What a volume may take of memory, and of time until it is shown.
struct LevelOptions {
  size_t maxWholeBytes = size_t{2} << 30U;   ///< a volume of no more bytes stands for itself
  size_t maxBytes = size_t{512} << 20U;      ///< of a level of means
  size_t maxBytesToRead = size_t{4} << 30U;  ///< for means; where it would be more, voxels are sampled instead
  size_t maxSampledBytes = size_t{128} << 20U;
};

/// The finest level that the options allow, or the whole itself.
VolumeLevel levelFor(std::shared_ptr<const ScalarVolume> whole, const LevelOptions& options,
                     const Progress& progress = {});

/// A sentence for the user: that a level stands for the whole, and how; empty where it is the whole.
std::string describeLevel(const VolumeLevel& level, const VolumeGrid& whole);

}  // namespace ocelli
