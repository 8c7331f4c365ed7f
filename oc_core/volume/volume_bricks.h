// The least and the greatest value in each brick of a volume: for skipping what is empty.
//
// Bricks divide the box of a volume, in index coordinates (volume_grid.h): brick (a, b, c) holds what lies from
// kEdge * (a, b, c) to kEdge * (a + 1, b + 1, c + 1), and the outermost ones hold the half voxels beyond the outermost
// centres, too. Its range is that of the field in it, so it takes in the voxels on its upper faces, which trilinear
// interpolation reaches from within. Neither the colours that gradients shade nor anything else beyond the field itself
// reaches farther.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

/// Of values (ScalarVolume::valueAt), rounded outwards to floats: nothing in the brick lies beyond.
struct BrickRange {
  float least = 0;
  float greatest = 0;
};

class VolumeBricks {
 public:
  static constexpr int kEdge = 8;  ///< distances of voxels, along i, j and k

  /// Reads all voxels once, on all threads; holes of sparse files are not read. Voxels are numbers: not NaN.
  explicit VolumeBricks(const ScalarVolume& volume);

  /// How many there are along i, j and k: at least 1.
  const glm::ivec3& size() const { return size_; }
  const BrickRange& range(const glm::ivec3& brick) const { return ranges_[indexOf(brick)]; }
  /// Of all bricks, i fastest.
  const std::vector<BrickRange>& ranges() const { return ranges_; }
  size_t indexOf(const glm::ivec3& brick) const {
    return (size_t(brick.z) * size_t(size_.y) + size_t(brick.y)) * size_t(size_.x) + size_t(brick.x);
  }

 private:
  glm::ivec3 size_;
  std::vector<BrickRange> ranges_;
};

/// The least and the greatest value of the field in all bricks.
ValueRange rangeOf(const VolumeBricks& bricks);

}  // namespace ocelli
