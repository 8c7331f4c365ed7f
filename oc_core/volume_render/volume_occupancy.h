// Where a volume shows nothing, by bricks of voxels, and how far from there it shows nothing either.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/volume/volume_bricks.h"
#include "oc_core/volume_render/optical_table.h"

namespace ocelli {

class VolumeOccupancy {
 public:
  VolumeOccupancy(const VolumeBricks& bricks, const OpticalTable& table);

  const glm::ivec3& size() const { return size_; }
  /// Of each brick, i fastest: 0 where it shows something, or how many bricks away, in the direction of any axis or
  /// diagonal, the nearest one is that does; at most kMaxDistance. Some bytes follow that mean nothing, so that four
  /// can be read from anywhere.
  const std::vector<uint8_t>& distances() const { return distances_; }

  /// Around all bricks that show something: the first of them along each axis, and the last plus 1. The same where none
  /// does.
  const glm::ivec3& firstSeen() const { return firstSeen_; }
  const glm::ivec3& endSeen() const { return endSeen_; }

  static constexpr uint8_t kMaxDistance = 255;

 private:
  glm::ivec3 size_;
  std::vector<uint8_t> distances_;
  glm::ivec3 firstSeen_{0};
  glm::ivec3 endSeen_{0};
};

}  // namespace ocelli
