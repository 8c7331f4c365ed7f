#include "oc_core/scene/point_tree.h"

#include <algorithm>
#include <glm/common.hpp>
#include <tuple>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/scene/box.h"

namespace ocelli {
namespace {

constexpr size_t kLeafPoints = 8;
constexpr size_t kPointsPerTask = 1 << 15;  ///< smaller parts are split on one thread

size_t middleOf(size_t begin, size_t end) {
  return begin + (end - begin) / 2;
}

float squared(float x) {
  return x * x;
}

}  // namespace

PointTree::PointTree(std::span<const glm::vec3> points) {
  OC_CHECK(points.size() <= 0xffffffffu, "points have numbers of 32 bits");
  items_.resize(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    items_[i] = {points[i], static_cast<uint32_t>(i)};
  }
  // The left half is the larger one.
  size_t nodes = 1;
  for (size_t size = points.size(); size > kLeafPoints; size /= 2) {
    nodes = 2 * nodes + 1;
  }
  axes_.resize(nodes);
  split(0, 0, items_.size());
}

void PointTree::split(size_t node, size_t begin, size_t end) {
  if (end - begin <= kLeafPoints) {
    return;
  }
  Box box;
  for (size_t i = begin; i < end; ++i) {
    box.lower = glm::min(box.lower, items_[i].position);
    box.upper = glm::max(box.upper, items_[i].position);
  }
  const glm::vec3 size = box.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const size_t middle = middleOf(begin, end);
  const auto at = [&](size_t place) { return items_.begin() + static_cast<std::ptrdiff_t>(place); };
  std::nth_element(at(begin), at(middle), at(end), [axis](const Item& a, const Item& b) {
    return std::tie(a.position[axis], a.point) < std::tie(b.position[axis], b.point);
  });
  axes_[node] = static_cast<uint8_t>(axis);
  const auto splitChild = [&](size_t child) {
    split(2 * node + 1 + child, child == 0 ? begin : middle + 1, child == 0 ? middle : end);
  };
  if (end - begin > kPointsPerTask) {
    parallelFor(2, 1, [&](size_t first, size_t last) {
      for (size_t child = first; child < last; ++child) {
        splitChild(child);
      }
    });
  } else {
    splitChild(0);
    splitChild(1);
  }
}

class PointTree::Search {
 public:
  Search(const PointTree& tree, uint32_t point, const glm::vec3& position, size_t count,
         std::array<PointNeighbor, kMaxNeighbors>& found)
      : tree_(tree), point_(point), position_(position), count_(count), found_(found) {}

  size_t run() {
    visit(0, 0, tree_.items_.size());
    return size_;
  }

 private:
  void visit(size_t node, size_t begin, size_t end) {
    if (end - begin <= kLeafPoints) {
      for (size_t i = begin; i < end; ++i) {
        offer(tree_.items_[i]);
      }
      return;
    }
    const size_t middle = middleOf(begin, end);
    const int axis = tree_.axes_[node];
    const float beyond = position_[axis] - tree_.items_[middle].position[axis];
    const auto visitChild = [&](size_t child) {
      visit(2 * node + 1 + child, child == 0 ? begin : middle + 1, child == 0 ? middle : end);
    };
    const size_t near = beyond < 0 ? 0 : 1;
    visitChild(near);
    offer(tree_.items_[middle]);
    // Equally near points with a lower number may still be there.
    if (size_ < count_ || squared(beyond) <= found_[size_ - 1].distance2) {
      visitChild(1 - near);
    }
  }

  void offer(const Item& item) {
    if (item.point == point_) {
      return;
    }
    const glm::vec3 away = item.position - position_;
    const PointNeighbor neighbor{away.x * away.x + away.y * away.y + away.z * away.z, item.point};
    const auto isBefore = [](const PointNeighbor& a, const PointNeighbor& b) {
      return std::tie(a.distance2, a.point) < std::tie(b.distance2, b.point);
    };
    if (size_ == count_ && !isBefore(neighbor, found_[size_ - 1])) {
      return;
    }
    size_t place = size_ < count_ ? size_++ : size_ - 1;
    for (; place > 0 && isBefore(neighbor, found_[place - 1]); --place) {
      found_[place] = found_[place - 1];
    }
    found_[place] = neighbor;
  }

  const PointTree& tree_;
  uint32_t point_;
  glm::vec3 position_;
  size_t count_;
  std::array<PointNeighbor, kMaxNeighbors>& found_;
  size_t size_ = 0;
};

std::span<const PointNeighbor> PointTree::nearest(uint32_t point, const glm::vec3& position, size_t count,
                                                  std::array<PointNeighbor, kMaxNeighbors>& found) const {
  OC_CHECK(count > 0 && count <= kMaxNeighbors, "neighbours are one or more, and fit into the array");
  return {found.data(), Search(*this, point, position, count, found).run()};
}

}  // namespace ocelli
