// Volumes of blocks in the clear, whose first hits can be derived by hand.
#pragma once

#include <glm/vector_relational.hpp>
#include <utility>
#include <vector>

#include "tests/volume/field_volume.h"

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
  const VolumeGrid grid = gridOfCube(kBlocksEdge, 1);
  const double spacing = 2.0 / kBlocksEdge;
  std::vector<float> values = voxelsOf(grid.size, [&](const glm::dvec3& p) {
    float value = 0;
    for (const Block& block : blocks) {
      const bool isIn = glm::all(glm::greaterThanEqual(p, glm::dvec3(block.lower))) &&
                        glm::all(glm::lessThan(p, glm::dvec3(block.upper)));
      value = isIn ? block.value : value;
    }
    return value;
  });
  const glm::dvec3 red(0.8, 0.1, 0.1);
  const glm::dvec3 grey(0.5);
  TransferFunction transfer({{-0.55, grey, 0.9}, {-0.45, grey, 0}, {0.45, red, 0}, {0.55, red, 0.9}}, spacing / 2);
  return sceneOfVoxels(grid, std::move(values), std::move(transfer));
}

/// A red block, z from 0.25 to 0.5, |x| and |y| below 0.25, before a grey wall, z from -0.75 to -0.5. The default eye
/// looks from +z.
inline VolumeScene blockBeforeWall() {
  return sceneOfBlocks({{{24, 24, 40}, {40, 40, 48}, 1}, {{0, 0, 8}, {64, 64, 16}, -1}});
}

}  // namespace ocelli::test
