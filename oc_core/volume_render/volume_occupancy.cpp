#include "oc_core/volume_render/volume_occupancy.h"

#include <algorithm>
#include <glm/common.hpp>

namespace ocelli {
namespace {

constexpr size_t kPadding = 3;

/// The brick's distance is at most one more than that of each of the 13 neighbours that come before it, in the order
/// of memory, or after it.
void nearBricks(std::vector<uint8_t>& distances, const glm::ivec3& size, int sign) {
  const auto step = [&](int i, int count) { return sign > 0 ? i : count - 1 - i; };
  const auto at = [&](int x, int y, int z) -> uint8_t& {
    return distances[static_cast<size_t>((z * size.y + y) * size.x + x)];
  };
  for (int k = 0; k < size.z; ++k) {
    for (int j = 0; j < size.y; ++j) {
      for (int i = 0; i < size.x; ++i) {
        const glm::ivec3 brick(step(i, size.x), step(j, size.y), step(k, size.z));
        uint8_t& distance = at(brick.x, brick.y, brick.z);
        if (distance == 0) {
          continue;
        }
        int least = distance;
        for (int n = 0; n < 13; ++n) {
          const glm::ivec3 other = brick + sign * glm::ivec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
          if (other.x >= 0 && other.y >= 0 && other.z >= 0 && other.x < size.x && other.y < size.y &&
              other.z < size.z) {
            least = std::min(least, at(other.x, other.y, other.z) + 1);
          }
        }
        distance = static_cast<uint8_t>(least);
      }
    }
  }
}

}  // namespace

VolumeOccupancy::VolumeOccupancy(const VolumeBricks& bricks, const OpticalTable& table)
    : size_(bricks.size()), distances_(bricks.ranges().size() + kPadding, kMaxDistance) {
  for (size_t i = 0; i < bricks.ranges().size(); ++i) {
    const BrickRange& range = bricks.ranges()[i];
    if (!table.isEmpty(static_cast<double>(range.least), static_cast<double>(range.greatest))) {
      distances_[i] = 0;
    }
  }
  firstSeen_ = size_;
  for (int k = 0; k < size_.z; ++k) {
    for (int j = 0; j < size_.y; ++j) {
      for (int i = 0; i < size_.x; ++i) {
        if (distances_[bricks.indexOf({i, j, k})] == 0) {
          firstSeen_ = glm::min(firstSeen_, {i, j, k});
          endSeen_ = glm::max(endSeen_, glm::ivec3(i, j, k) + 1);
        }
      }
    }
  }
  firstSeen_ = glm::min(firstSeen_, endSeen_);
  nearBricks(distances_, size_, 1);
  nearBricks(distances_, size_, -1);
}

}  // namespace ocelli
