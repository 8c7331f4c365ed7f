// Gradients of the field of a volume, in double precision: the reference of what is faster.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

/// The gradient of the field in the world of the grid, at index coordinates in the box of the volume: by central
/// differences over one voxel to each side. Differences stop at the outermost centres (over what remains of them), and
/// are 0 along axes of one voxel.
glm::dvec3 gradientAt(const ScalarVolume& volume, const glm::dvec3& index);

/// From derivatives along i, j and k to the world: the transposed inverse of `worldFromIndex`.
glm::dmat3 worldGradientFromIndex(const glm::dmat4& worldFromIndex);

}  // namespace ocelli
