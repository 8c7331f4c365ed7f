// Coarser volumes: what is finer than a display can show is averaged first.
#pragma once

#include <glm/mat4x4.hpp>

#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

/// Each voxel is the mean of the `factor` x `factor` x `factor` that it covers, fewer at an end that does not divide.
/// In single precision, on all threads. Its world is that of `volume`; `factor` is at least 1.
ScalarVolume coarserVolume(const ScalarVolume& volume, int factor);

/// From the index coordinates of a coarser volume to those of the volume it was made of.
glm::dmat4 fineFromCoarserIndex(int factor);

}  // namespace ocelli
