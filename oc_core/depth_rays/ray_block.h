// The rays of neighbouring pixels of a pinhole, which start at one place: what a pyramid answers together.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <limits>

#include "oc_core/depth_rays/straight_ray.h"

namespace ocelli {

struct RayBlock {
  static constexpr int kMaxSide = 8;
  static constexpr int kMaxRays = kMaxSide * kMaxSide;

  glm::vec3 origin{0};
  glm::vec3 first{0};      ///< the step of the ray at column 0, row 0
  glm::vec3 perColumn{0};  ///< what the step grows by from column to column: all three are independent
  glm::vec3 perRow{0};
  int columns = 0;  ///< 1 to kMaxSide
  int rows = 0;
  /// Of each ray, row by row: what it meets first, nearer than its reach.
  std::array<float, kMaxRays> reach;
  std::array<TriangleMeeting, kMaxRays> meeting;
  std::array<bool, kMaxRays> meets;

  int indexOf(int column, int row) const { return row * columns + column; }
  int rays() const { return columns * rows; }
  StraightRay ray(int column, int row) const {
    return {origin, first + perColumn * static_cast<float>(column) + perRow * static_cast<float>(row),
            reach[static_cast<size_t>(indexOf(column, row))]};
  }
};

}  // namespace ocelli
