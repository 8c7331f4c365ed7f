// Boxes along the axes of the world.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

namespace ocelli {

/// An axis-aligned box; `lower` exceeds `upper` where it holds nothing.
struct Box {
  glm::vec3 lower{1e30f};
  glm::vec3 upper{-1e30f};

  bool empty() const { return lower.x > upper.x; }
  void add(const glm::vec3& point);
  glm::vec3 center() const { return (lower + upper) * 0.5f; }
  glm::vec3 size() const { return upper - lower; }
};

/// Of a box that is not empty: bit 0 of the index says whether x is that of `upper`, bit 1 says so of y, and bit 2 of
/// z.
std::array<glm::vec3, 8> cornersOf(const Box& box);

/// Whether a point is in a box; its faces count.
bool contains(const Box& box, const glm::vec3& point);

/// Shares of a segment's length, from 0 to 1.
struct SegmentPart {
  double first = 0;
  double last = 1;  ///< not less than `first`
};

/// What of a segment is in a box, whose faces count: a single point where it touches. Nothing where it misses the box.
std::optional<SegmentPart> partWithin(const Box& box, const glm::dvec3& from, const glm::dvec3& to);

/// Whether a segment has a point in the box.
bool meets(const Box& box, const glm::vec3& from, const glm::vec3& to);

}  // namespace ocelli
