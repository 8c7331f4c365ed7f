// Vertices of an extracted surface, moved to where the field has its value: the extractor puts a vertex at the mean of
// the points where the edges of a cell meet the surface, which lies beside it where the surface is curved.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

/// The gradient of the field between voxel centres, by index coordinates: central differences over a voxel each way,
/// shorter at the outermost centres. Zero along axes of one voxel.
glm::dvec3 indexGradient(const ScalarVolume& volume, const glm::dvec3& index);

/// Whether a point lies between the outermost voxel centres: the field does not change in the half voxel beyond them.
bool isBetweenCenters(const VolumeGrid& grid, const glm::dvec3& index);

/// Moves each point that lies between the outermost centres, by half a voxel along each axis at the most, and only
/// nearer to the value. On all threads.
void fitToField(std::vector<glm::vec3>& points, const ScalarVolume& volume, double value);

}  // namespace ocelli
