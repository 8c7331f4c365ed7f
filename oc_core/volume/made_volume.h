// What made volumes share: grids around the origin, and filling them on all threads. For .cpp files of this room.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "oc_core/base/parallel.h"
#include "oc_core/volume/builtin_volumes.h"
#include "oc_core/volume/transfer_presets.h"

namespace ocelli {

/// With its box around the origin, and its axes those of the world.
inline VolumeGrid gridAroundOrigin(const glm::ivec3& size, double spacing) {
  VolumeGrid grid{.size = size};
  grid.worldFromIndex = glm::dmat4(spacing);
  grid.worldFromIndex[3] = glm::dvec4(-0.5 * spacing * glm::dvec3(size - 1), 1);
  return grid;
}

/// The type of voxels that hold a Voxel.
template <class Voxel>
constexpr VoxelType voxelTypeOf() {
  if constexpr (std::is_same_v<Voxel, uint8_t>) {
    return VoxelType::kUint8;
  } else if constexpr (std::is_same_v<Voxel, int16_t>) {
    return VoxelType::kInt16;
  } else {
    static_assert(std::is_same_v<Voxel, float>);
    return VoxelType::kFloat32;
  }
}

/// Calls `fillRow(j, k, row)` for each row of voxels, on all threads.
template <class Voxel, class FillRow>
ScalarVolume madeVolume(const VolumeGrid& grid, const FillRow& fillRow) {
  const auto voxels = std::make_shared<std::vector<Voxel>>(grid.voxelCount());
  const auto width = static_cast<size_t>(grid.size.x);
  const auto height = static_cast<size_t>(grid.size.y);
  parallelFor(grid.voxelCount() / width, 8, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      fillRow(static_cast<int>(row % height), static_cast<int>(row / height),
              std::span<Voxel>(*voxels).subspan(row * width, width));
    }
  });
  return {grid, voxelTypeOf<Voxel>(), std::as_bytes(std::span(*voxels)), voxels};
}

/// The number of voxels along each edge of a made volume, between which others interpolate: `size=N`.
inline BuiltinParameter sizeParameter(int otherwise) {
  return {.name = "size",
          .summary = "voxels along its longest edge",
          .kind = BuiltinParameter::Kind::kInteger,
          .otherwise = std::to_string(otherwise),
          .least = 8,
          .most = 1024};
}

}  // namespace ocelli
