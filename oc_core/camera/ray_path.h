// The ray of one pixel: world points from near to far, joined by straight segments, and a parameter t that grows along
// it. Each point has its t; between two points t grows in proportion to the length.
//
// The points lie in the object itself, so that a ray of each pixel of an image costs no memory allocation.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <limits>

#include "oc_core/base/check.h"

namespace ocelli {

class RayPath {
 public:
  static constexpr size_t kMaxPoints = 104;

  RayPath() = default;
  /// t is the length along the path.
  RayPath(std::initializer_list<glm::vec3> points) {
    for (const glm::vec3& point : points) {
      push_back(point);
    }
  }
  RayPath(const RayPath& other) { *this = other; }
  RayPath& operator=(const RayPath& other) {
    size_ = other.size_;
    std::copy(other.begin(), other.end(), points_.begin());
    std::copy(other.parameters_.begin(), other.parameters_.begin() + other.size_, parameters_.begin());
    return *this;
  }

  /// `t` is greater than that of the point before.
  void add(const glm::vec3& point, float t) {
    OC_CHECK(size_ < kMaxPoints, "a ray path has too many points");
    parameters_[size_] = t;
    points_[size_++] = point;
  }
  /// Its t is that of the point before, 0 for the first point, plus the length of the way from there.
  // As std::vector calls it.
  void push_back(const glm::vec3& point) {  // NOLINT(readability-identifier-naming)
    add(point, size_ == 0 ? 0 : tMax() + glm::distance(back(), point));
  }

  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const glm::vec3& operator[](size_t i) const { return points_[i]; }
  const glm::vec3& front() const { return points_[0]; }
  const glm::vec3& back() const { return points_[size_ - 1]; }
  const glm::vec3* begin() const { return points_.data(); }
  const glm::vec3* end() const { return points_.data() + size_; }

  /// The parameter of point `i`.
  float t(size_t i) const { return parameters_[i]; }
  float tMin() const { return parameters_[0]; }
  float tMax() const { return parameters_[size_ - 1]; }

  /// A position on the path: `share` of the way from point `segment` to the next one.
  struct Position {
    size_t segment = 0;
    float share = 0;
  };
  /// Where the parameter is `t`; the nearer end for what lies beyond an end. The path has two points or more.
  Position positionAt(float t) const {
    const auto first = parameters_.begin() + 1;
    const auto next = std::upper_bound(first, first + (size_ - 2), t);
    const auto segment = static_cast<size_t>(next - first);
    const float length = parameters_[segment + 1] - parameters_[segment];
    return {segment, length > 0 ? std::clamp((t - parameters_[segment]) / length, 0.0f, 1.0f) : 0.0f};
  }
  /// The position that is closest to `point`; of equally close ones the first. The path has two points or more.
  Position positionNear(const glm::vec3& point) const {
    Position best;
    float least = std::numeric_limits<float>::infinity();
    for (size_t i = 0; i + 1 < size_; ++i) {
      const glm::vec3 way = points_[i + 1] - points_[i];
      const float length2 = std::max(glm::dot(way, way), 1e-30f);
      const float share = std::clamp(glm::dot(point - points_[i], way) / length2, 0.0f, 1.0f);
      const float distance = glm::distance(points_[i] + way * share, point);
      if (distance < least) {
        least = distance;
        best = {i, share};
      }
    }
    return best;
  }
  float tAt(const Position& p) const {
    return parameters_[p.segment] + (parameters_[p.segment + 1] - parameters_[p.segment]) * p.share;
  }
  glm::vec3 pointAt(const Position& p) const {
    return points_[p.segment] + (points_[p.segment + 1] - points_[p.segment]) * p.share;
  }
  /// The way that the path goes there: a unit vector, or 0 where two of its points are the same.
  glm::vec3 directionAt(const Position& p) const {
    const glm::vec3 way = points_[p.segment + 1] - points_[p.segment];
    const float length = glm::length(way);
    return length > 0 ? way / length : glm::vec3(0);
  }

  bool operator==(const RayPath& other) const {
    return std::equal(begin(), end(), other.begin(), other.end()) &&
           std::equal(parameters_.begin(), parameters_.begin() + size_, other.parameters_.begin());
  }

 private:
  size_t size_ = 0;
  // Only the first size_ of them hold anything.
  std::array<glm::vec3, kMaxPoints> points_;
  std::array<float, kMaxPoints> parameters_;
};

}  // namespace ocelli
