#include "display_sim/slicing/sector_clip.h"

namespace ocelli {
namespace {

/// `outward` is the distance from the axis along the sector's direction, `across` the one at right angles, in columns.
struct SectorPoint {
  double outward;
  double across;
  double v;
  double b1;
  double b2;
};

SectorPoint mix(const SectorPoint& a, const SectorPoint& b, double t) {
  return {a.outward + (b.outward - a.outward) * t, a.across + (b.across - a.across) * t, a.v + (b.v - a.v) * t,
          a.b1 + (b.b1 - a.b1) * t, a.b2 + (b.b2 - a.b2) * t};
}

struct SectorPolygon {
  std::array<SectorPoint, 6> points;
  int size = 0;
};

/// Keeps what has outward * slope + side * across >= 0 (Sutherland and Hodgman).
SectorPolygon clipToBorder(const SectorPolygon& polygon, double slope, double side) {
  SectorPolygon kept;
  const SectorPoint* a = &polygon.points[static_cast<size_t>(polygon.size - 1)];
  double inA = a->outward * slope + side * a->across;
  for (int i = 0; i < polygon.size; ++i) {
    const SectorPoint* b = &polygon.points[static_cast<size_t>(i)];
    const double inB = b->outward * slope + side * b->across;
    if ((inA < 0) != (inB < 0)) {
      kept.points[static_cast<size_t>(kept.size++)] = mix(*a, *b, inA / (inA - inB));
    }
    if (inB >= 0) {
      kept.points[static_cast<size_t>(kept.size++)] = *b;
    }
    a = b;
    inA = inB;
  }
  return kept;
}

}  // namespace

ScreenPolygon clipToSector(const SweepGeometry& sweep, const SweepTriangle& triangle, int sector) {
  const glm::dvec2& direction = sweep.sectorDirection(sector);
  const double slope = sweep.tanHalfStep();
  SectorPolygon polygon;
  polygon.size = 3;
  int outsideLeft = 0;
  int outsideRight = 0;
  for (size_t k = 0; k < 3; ++k) {
    const glm::dvec3& p = triangle.corners[k];
    const double outward = p.x * direction.x + p.z * direction.y;
    const double across = p.z * direction.x - p.x * direction.y;
    polygon.points[k] = {outward, across, p.y, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
    outsideLeft += outward * slope + across < 0 ? 1 : 0;
    outsideRight += outward * slope - across < 0 ? 1 : 0;
  }
  if (outsideLeft == 3 || outsideRight == 3) {
    return {};
  }
  if (outsideLeft > 0) {
    polygon = clipToBorder(polygon, slope, 1);
  }
  if (outsideRight > 0 && polygon.size > 0) {
    polygon = clipToBorder(polygon, slope, -1);
  }
  ScreenPolygon screen;
  screen.size = polygon.size;
  const double axis = sweep.columnsPerRadius();
  const double side = sweep.sideOfSector(sector);
  for (size_t k = 0; k < static_cast<size_t>(polygon.size); ++k) {
    const SectorPoint& p = polygon.points[k];
    screen.points[k] = {axis + side * p.outward, p.v, p.b1, p.b2};
  }
  return screen;
}

}  // namespace ocelli
