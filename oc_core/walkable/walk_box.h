// The box that fits a piece of floor best.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/walkable/walk_field.h"

namespace ocelli {

/// A rectangle in the plan of a field, in units of the scene. (x, z) = center + u * axis + v * right, where right is to
/// the right of someone who looks along the axis.
struct WalkBox {
  glm::dvec2 center{0};
  glm::dvec2 axis{1, 0};
  double halfLength = 0;  ///< along the axis
  double halfWidth = 0;

  glm::dvec2 right() const { return {-axis.y, axis.x}; }
  glm::dvec2 at(double u, double v) const { return center + u * axis + v * right(); }
};

/// A box, and how well it fits: the area that it shares with the squares, of the area that either covers.
struct BoxFit {
  WalkBox box;
  double shared = 0;
};

/// The middle of a square in the plan.
glm::dvec2 middleOf(const WalkField& field, const WalkSquare& square);

/// Fits a box to squares: along the axes of the grid where that fits well, else turned. `axis` is given for tunnels
/// whose direction is known; where it is zero, it is that of the longer side.
BoxFit boxAround(const WalkField& field, const std::vector<uint32_t>& squares, const glm::dvec2& axis);

}  // namespace ocelli
