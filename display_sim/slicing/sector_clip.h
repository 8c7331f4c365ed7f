// The part of a triangle that lies in a sector of the sweep, as a polygon on the plane of the slice.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/slicing/screen_polygon.h"

namespace ocelli {

/// A triangle ready to be clipped: x and z in columns from the axis, y as screen coordinate v.
struct SweepTriangle {
  std::array<glm::dvec3, 3> corners;  ///< (x, v, z)
};

inline glm::dvec3 sweepPoint(const SweepGeometry& sweep, const glm::vec3& p) {
  return {p.x * sweep.columnsPerRadius(), sweep.rowOfY(p.y), p.z * sweep.columnsPerRadius()};
}

/// Empty (size 0) where the triangle does not touch the sector, borders included.
ScreenPolygon clipToSector(const SweepGeometry& sweep, const SweepTriangle& triangle, int sector);

}  // namespace ocelli
