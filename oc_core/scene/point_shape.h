// What the neighbours of a point say of the surface through it: its normal, and how much of it is nearer to the point
// than to any other.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

namespace ocelli {

struct PointPlane {
  glm::vec3 normal;  ///< a unit vector, whose sign is of no meaning
  bool isSurface;    ///< the points are spread along the plane, not along a line or about as far off it
};

/// The plane that fits a point and its neighbours best: its normal is the direction of least variance (Hoppe et al.
/// 1992, section 3.1). `offsets` lead from the point to the neighbours, of which there is one or more.
PointPlane fittingPlane(std::span<const glm::vec3> offsets);

inline constexpr size_t kMaxPanelNeighbors = 16;

/// A rectangle in the plane through a point.
struct PointPanel {
  glm::vec3 center;  ///< from the point
  glm::vec3 halfX;
  glm::vec3 halfY;  ///< at right angles to halfX; halfX x halfY is towards the normal
};

/// The least rectangle, along the axes of the neighbours' spread, around the Voronoi cell that the point has among them
/// in the plane with that unit normal, no farther from the point than `reach`. Points of a flat surface are closed so,
/// however unevenly they lie. Neighbours farther off the plane than along it are on another surface, and do not count.
/// There are kMaxPanelNeighbors at most.
PointPanel cellPanel(std::span<const glm::vec3> offsets, const glm::vec3& normal, float reach);

/// A square of that half width about the point, along the same axes.
PointPanel squarePanel(std::span<const glm::vec3> offsets, const glm::vec3& normal, float half);

}  // namespace ocelli
