// A convex polygon on the plane of a slice and the pixel squares it touches, found exactly: in each row the polygon's
// part is convex, so the squares it touches are those that its horizontal extent touches.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ocelli {

/// A point of a triangle on the screen: q to the right and v downwards in pixels; b1 and b2 are its barycentric weights
/// for the triangle's second and third vertex.
struct ScreenPoint {
  double q = 0;
  double v = 0;
  double b1 = 0;
  double b2 = 0;
};

inline ScreenPoint mix(const ScreenPoint& a, const ScreenPoint& b, double t) {
  return {a.q + (b.q - a.q) * t, a.v + (b.v - a.v) * t, a.b1 + (b.b1 - a.b1) * t, a.b2 + (b.b2 - a.b2) * t};
}

/// A triangle clipped by two planes has at most five corners; rounding may add one.
struct ScreenPolygon {
  std::array<ScreenPoint, 6> points;
  int size = 0;
};

/// The first and last of the `count` unit cells that the closed interval [lo, hi] touches, faces included; none where
/// first > last.
struct CellRange {
  int first = 0;
  int last = -1;
};

inline CellRange touchedCells(double lo, double hi, int count) {
  if (!(hi >= 0 && lo <= count)) {
    return {};
  }
  // Truncation is floor() for what is not negative; it is an instruction of every x86-64, which floor() is not.
  const int last = static_cast<int>(std::min(hi, static_cast<double>(count)));
  const double from = std::max(lo, 0.0);
  const int floorFrom = static_cast<int>(from);
  const int first = static_cast<double>(floorFrom) == from ? floorFrom - 1 : floorFrom;
  return {std::max(first, 0), std::min(last, count - 1)};
}

/// Finds the pixel squares that polygons touch. Holds scratch memory: one for each thread.
class PolygonRaster {
 public:
  PolygonRaster(int width, int height) : width_(width), height_(height), rows_(static_cast<size_t>(height)) {}

  /// Calls `visit(column, row, b1, b2)` once for each touched square, with the weights of a point of the polygon inside
  /// it.
  template <class Visit>
  void touch(const ScreenPolygon& polygon, Visit&& visit) {
    const CellRange range = findExtents(polygon);
    for (int row = range.first; row <= range.last; ++row) {
      const Extent& extent = rows_[static_cast<size_t>(row)];
      const CellRange columns = touchedCells(extent.lo.q, extent.hi.q, width_);
      const double length = extent.hi.q - extent.lo.q;
      for (int column = columns.first; column <= columns.last; ++column) {
        // The chord between the leftmost and the rightmost point, where it is nearest to the centre of the column.
        const double t = length > 0 ? std::clamp((column + 0.5 - extent.lo.q) / length, 0.0, 1.0) : 0.0;
        visit(column, row, extent.lo.b1 + (extent.hi.b1 - extent.lo.b1) * t,
              extent.lo.b2 + (extent.hi.b2 - extent.lo.b2) * t);
      }
    }
  }

 private:
  struct Extent {
    ScreenPoint lo;
    ScreenPoint hi;
  };

  /// Fills rows_ for the returned range of rows.
  CellRange findExtents(const ScreenPolygon& polygon);
  void extend(const CellRange& rows, const ScreenPoint& point);

  int width_;
  int height_;
  std::vector<Extent> rows_;
};

}  // namespace ocelli
