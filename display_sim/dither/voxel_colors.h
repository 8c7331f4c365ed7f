// The colours of the voxels that a surface passes through, before anything reduces them to levels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace ocelli {

struct ColoredVoxel {
  uint32_t position = 0;  ///< row * width + column
  glm::vec3 color{0};

  bool operator==(const ColoredVoxel&) const = default;
};

/// One slice's, each position once, from the top left row by row.
using SliceColors = std::vector<ColoredVoxel>;
/// Of all stored slices.
using VoxelColors = std::vector<SliceColors>;

/// Puts voxels in order. A position that comes more than once gets its highest light in each channel.
void sortAndUnite(SliceColors& voxels);

}  // namespace ocelli
