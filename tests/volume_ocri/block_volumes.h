// Volumes of blocks in the clear, whose first hits can be derived by hand.
#pragma once

#include <algorithm>
#include <vector>

#include "oc_core/volume/volume_scene.h"

namespace ocelli::test {

/// Voxels [lower, upper) along each index that hold a value.
struct Block {
  glm::ivec3 lower{0};
  glm::ivec3 upper{0};
  float value = 1;
};

inline constexpr int kBlocksEdge = 64;
inline constexpr float kBlocksSpacing = 2.0f / kBlocksEdge;

/// 64 voxels along each axis fill the cube from -1 to 1. The value 1 is red and -1 grey, both as good as opaque: nine
/// tenths of the light are lost in half a voxel. 0 is clear.
inline VolumeScene sceneOfBlocks(const std::vector<Block>& blocks) {
  VolumeGrid grid;
  grid.size = glm::ivec3(kBlocksEdge);
  const double spacing = 2.0 / kBlocksEdge;
  grid.worldFromIndex = glm::dmat4(glm::dvec4(spacing, 0, 0, 0), glm::dvec4(0, spacing, 0, 0),
                                   glm::dvec4(0, 0, spacing, 0), glm::dvec4(glm::dvec3(spacing / 2 - 1), 1));
  std::vector<float> values(grid.voxelCount(), 0.0f);
  for (const Block& block : blocks) {
    for (int k = block.lower.z; k < block.upper.z; ++k) {
      for (int j = block.lower.y; j < block.upper.y; ++j) {
        for (int i = block.lower.x; i < block.upper.x; ++i) {
          values[(static_cast<size_t>(k) * kBlocksEdge + static_cast<size_t>(j)) * kBlocksEdge +
                 static_cast<size_t>(i)] = block.value;
        }
      }
    }
  }
  const glm::dvec3 red(0.8, 0.1, 0.1);
  const glm::dvec3 grey(0.5);
  TransferFunction transfer({{-0.55, grey, 0.9}, {-0.45, grey, 0}, {0.45, red, 0}, {0.55, red, 0.9}}, spacing / 2);
  const glm::dmat4 worldFromIndex = grid.worldFromIndex;
  return {.volume = std::make_shared<ScalarVolume>(std::move(grid), std::move(values)),
          .worldFromIndex = worldFromIndex,
          .appearance = {.transfer = std::move(transfer)}};
}

/// A red block, z from 0.25 to 0.5, |x| and |y| below 0.25, before a grey wall, z from -0.75 to -0.5. The default eye
/// looks from +z.
inline VolumeScene blockBeforeWall() {
  return sceneOfBlocks({{{24, 24, 40}, {40, 40, 48}, 1}, {{0, 0, 8}, {64, 64, 16}, -1}});
}

}  // namespace ocelli::test
