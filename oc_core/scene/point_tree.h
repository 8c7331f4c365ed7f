// The nearest neighbours of points: a k-d tree (Bentley 1975) that splits at medians, so that no choice of points makes
// it deep.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ocelli {

struct PointNeighbor {
  float distance2 = 0;
  uint32_t point = 0;
};

class PointTree {
 public:
  static constexpr size_t kMaxNeighbors = 16;

  /// Takes 16 bytes a point. Coordinates are finite, and below 1e18 in size.
  explicit PointTree(std::span<const glm::vec3> points);

  /// The `count` (kMaxNeighbors at most) points nearest to point number `point`, without it, nearest first; of those
  /// that are equally near, the lower numbers. Fewer where there are no more. They stand in `found`.
  std::span<const PointNeighbor> nearest(uint32_t point, const glm::vec3& position, size_t count,
                                         std::array<PointNeighbor, kMaxNeighbors>& found) const;

  /// The numbers of the points in an order in which near ones tend to follow each other.
  uint32_t pointAt(size_t place) const { return items_[place].point; }

 private:
  struct Item {
    glm::vec3 position;
    uint32_t point;
  };
  class Search;

  void split(size_t node, size_t begin, size_t end);

  std::vector<Item> items_;  ///< of a node: those of its left child, the one where it splits, those of its right child
  std::vector<uint8_t> axes_;  ///< of the nodes, whose children are 2 i + 1 and 2 i + 2
};

}  // namespace ocelli
