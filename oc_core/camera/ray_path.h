// The ray of one pixel: world points from near to far, joined by straight segments.
//
// The points lie in the object itself, so that a ray of each pixel of an image costs no memory allocation.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <initializer_list>

#include "oc_core/base/check.h"

namespace ocelli {

class RayPath {
 public:
  static constexpr size_t kMaxPoints = 104;

  RayPath() = default;
  RayPath(std::initializer_list<glm::vec3> points) {
    for (const glm::vec3& point : points) {
      push_back(point);
    }
  }
  RayPath(const RayPath& other) { *this = other; }
  RayPath& operator=(const RayPath& other) {
    size_ = other.size_;
    std::copy(other.begin(), other.end(), points_.begin());
    return *this;
  }

  // As std::vector calls it.
  void push_back(const glm::vec3& point) {  // NOLINT(readability-identifier-naming)
    OC_CHECK(size_ < kMaxPoints, "a ray path has too many points");
    points_[size_++] = point;
  }

  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const glm::vec3& operator[](size_t i) const { return points_[i]; }
  const glm::vec3& front() const { return points_[0]; }
  const glm::vec3& back() const { return points_[size_ - 1]; }
  const glm::vec3* begin() const { return points_.data(); }
  const glm::vec3* end() const { return points_.data() + size_; }

  bool operator==(const RayPath& other) const { return std::equal(begin(), end(), other.begin(), other.end()); }

 private:
  size_t size_ = 0;
  std::array<glm::vec3, kMaxPoints> points_;  // only the first size_ of them hold anything
};

}  // namespace ocelli
