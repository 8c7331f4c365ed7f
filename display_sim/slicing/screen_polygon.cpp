#include "display_sim/slicing/screen_polygon.h"

#include <limits>

namespace ocelli {

void PolygonRaster::extend(const CellRange& rows, const ScreenPoint& point) {
  for (int row = rows.first; row <= rows.last; ++row) {
    Extent& extent = rows_[static_cast<size_t>(row)];
    if (point.q < extent.lo.q) {
      extent.lo = point;
    }
    if (point.q > extent.hi.q) {
      extent.hi = point;
    }
  }
}

CellRange PolygonRaster::findExtents(const ScreenPolygon& polygon) {
  double top = polygon.points[0].v;
  double bottom = top;
  for (int i = 1; i < polygon.size; ++i) {
    top = std::min(top, polygon.points[static_cast<size_t>(i)].v);
    bottom = std::max(bottom, polygon.points[static_cast<size_t>(i)].v);
  }
  const CellRange range = touchedCells(top, bottom, height_);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (int row = range.first; row <= range.last; ++row) {
    rows_[static_cast<size_t>(row)].lo.q = kInfinity;
    rows_[static_cast<size_t>(row)].hi.q = -kInfinity;
  }
  if (range.first > range.last) {
    return range;
  }
  // Within a row the extreme points are corners of the polygon or lie where its outline crosses the row's border.
  for (int i = 0; i < polygon.size; ++i) {
    const ScreenPoint& a = polygon.points[static_cast<size_t>(i)];
    const ScreenPoint& b = polygon.points[static_cast<size_t>(i + 1 == polygon.size ? 0 : i + 1)];
    extend(touchedCells(a.v, a.v, height_), a);
    const CellRange rows = touchedCells(std::min(a.v, b.v), std::max(a.v, b.v), height_);
    const int firstBorder = std::min(a.v, b.v) < 0 ? 0 : rows.first + 1;
    const int lastBorder = std::max(a.v, b.v) > height_ ? height_ : rows.last;
    for (int border = firstBorder; border <= lastBorder; ++border) {
      const double t = (border - a.v) / (b.v - a.v);
      if (t > 0 && t < 1) {
        extend(touchedCells(border, border, height_), mix(a, b, t));
      }
    }
  }
  return range;
}

}  // namespace ocelli
