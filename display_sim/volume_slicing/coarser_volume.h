// Coarser volumes: what is finer than a display can show is averaged first.
#pragma once

#include <glm/mat4x4.hpp>

#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

/// Each voxel is the mean of those that it covers, `factor` along each axis and fewer at an end that does not divide.
/// In 16 bits of `range`: values beyond count as its ends. On all threads. Its world is that of `volume`; factors are
/// at least 1.
ScalarVolume coarserVolume(const ScalarVolume& volume, const glm::ivec3& factor, const ValueRange& range);

/// From the index coordinates of a coarser volume to those of the volume it was made of.
glm::dmat4 fineFromCoarserIndex(const glm::ivec3& factor);

}  // namespace ocelli
