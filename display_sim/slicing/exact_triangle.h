// The cells of the sweep that one triangle touches, found exactly: see exact_slicer.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/slicing/screen_polygon.h"
#include "display_sim/slicing/sector_clip.h"

namespace ocelli {

/// A vertex ready for slicing: (x, v, z) as sweepPoint() gives them, and its angle in steps of a sector, in [-N, N].
struct SweepVertex {
  glm::dvec3 point;
  double steps = 0;
};

SweepVertex sweepVertex(const SweepGeometry& sweep, const glm::vec3& position);

/// Sectors first, first + 1, ... first + count - 1, each modulo the number of sectors.
struct SectorRange {
  int first = 0;
  int count = 0;
};

/// The sectors that a triangle may touch: all where it holds the axis or comes too near to it to tell.
SectorRange sectorsOf(const SweepVertex& a, const SweepVertex& b, const SweepVertex& c, int sectors);

/// Calls `visit(sector, column, row, b1, b2)` once for each cell of these sectors that the triangle touches. b1 and b2
/// are the weights of its second and third corner at one of its points in the cell.
template <class Visit>
void forEachTouchedCell(const SweepGeometry& sweep, PolygonRaster& raster, const SweepTriangle& triangle,
                        const SectorRange& range, Visit&& visit) {
  for (int i = 0, sector = range.first; i < range.count; ++i) {
    const ScreenPolygon polygon = clipToSector(sweep, triangle, sector);
    if (polygon.size > 0) {
      raster.touch(polygon, [&](int column, int row, double b1, double b2) { visit(sector, column, row, b1, b2); });
    }
    sector = sector + 1 == sweep.sectors() ? 0 : sector + 1;
  }
}

/// Calls `visit(slice, column, share)` for the two cells between which the light of a point is shared in proportion to
/// the angle: that of its sector, and that of the nearest other one. `column` is in the point's own cell.
template <class Visit>
void forEachShare(const SweepGeometry& sweep, const glm::vec3& point, int sector, int column, Visit&& visit) {
  const double steps = std::atan2(point.z, point.x) / sweep.stepRadians() - sector;
  const double rest = std::clamp(steps - std::round(steps / sweep.sectors()) * sweep.sectors(), -0.5, 0.5);
  const int neighbour = (sector + (rest < 0 ? sweep.sectors() - 1 : 1)) % sweep.sectors();
  const bool mirrored = sweep.sideOfSector(neighbour) != sweep.sideOfSector(sector);
  visit(sweep.sliceOfSector(sector), column, static_cast<float>(1 - std::abs(rest)));
  visit(sweep.sliceOfSector(neighbour), mirrored ? sweep.width() - 1 - column : column,
        static_cast<float>(std::abs(rest)));
}

}  // namespace ocelli
