// Vertices of an extracted surface, moved to where the field has its value: the extractor puts a vertex at the mean of
// the points where the edges of a cell meet the surface, which lies beside it where the surface is curved.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

/// Whether a point lies between the outermost voxel centres: the field does not change in the half voxel beyond them.
bool isBetweenCenters(const VolumeGrid& grid, const glm::dvec3& index);

/// Moves points beyond the outermost centres to the faces of the box, and each point in whose cell the surface runs, by
/// half a voxel along each axis at the most and along those faces, nearer to the value. On all threads.
void fitToField(std::vector<glm::vec3>& points, const ScalarVolume& volume, double value);

}  // namespace ocelli
