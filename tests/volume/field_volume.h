// Volumes of fields that are given as functions: the one place where tests fill grids.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "oc_core/volume/volume_scene.h"

namespace ocelli::test {

/// Voxels in their order. `field` takes index coordinates, a glm::dvec3.
template <class Voxel = float, class Field>
std::vector<Voxel> voxelsOf(const glm::ivec3& size, const Field& field) {
  std::vector<Voxel> voxels;
  for (int k = 0; k < size.z; ++k) {
    for (int j = 0; j < size.y; ++j) {
      for (int i = 0; i < size.x; ++i) {
        voxels.push_back(static_cast<Voxel>(field(glm::dvec3(i, j, k))));
      }
    }
  }
  return voxels;
}

/// The same, where `field` takes points of the grid's world.
template <class Field>
std::vector<float> voxelsInWorld(const VolumeGrid& grid, const Field& field) {
  return voxelsOf(grid.size, [&](const glm::dvec3& index) {
    return field(glm::dvec3(grid.worldFromIndex * glm::dvec4(index, 1)));
  });
}

/// Voxels that fill the cube of this half side around the origin, so many a side.
inline VolumeGrid gridOfCube(int size, double halfSide) {
  VolumeGrid grid;
  grid.size = glm::ivec3(size);
  const double step = 2 * halfSide / size;
  grid.worldFromIndex = glm::dmat4(step);
  grid.worldFromIndex[3] = glm::dvec4(glm::dvec3(step / 2 - halfSide), 1);
  return grid;
}

/// A volume that keeps its own voxels, of any type.
template <class Voxel>
ScalarVolume volumeOfVoxels(VolumeGrid grid, VoxelType type, std::vector<Voxel> voxels, double scale = 1,
                            double offset = 0) {
  const auto owned = std::make_shared<const std::vector<Voxel>>(std::move(voxels));
  return {std::move(grid), type, std::as_bytes(std::span(*owned)), owned, scale, offset};
}

/// The world of the grid is the scene's.
inline VolumeScene sceneOfVoxels(VolumeGrid grid, std::vector<float> voxels, TransferFunction transfer) {
  const glm::dmat4 worldFromIndex = grid.worldFromIndex;
  return {.volume = std::make_shared<ScalarVolume>(std::move(grid), std::move(voxels)),
          .worldFromIndex = worldFromIndex,
          .appearance = {std::move(transfer)}};
}

}  // namespace ocelli::test
