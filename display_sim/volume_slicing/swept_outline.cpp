#include "display_sim/volume_slicing/swept_outline.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <vector>

namespace ocelli {
namespace {

/// Keeps what of a convex polygon has distance(p) >= 0, a linear function.
template <class Distance>
std::vector<glm::dvec2> clippedOutline(const std::vector<glm::dvec2>& polygon, const Distance& distance) {
  std::vector<glm::dvec2> kept;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2& from = polygon[i];
    const glm::dvec2& to = polygon[(i + 1) % polygon.size()];
    const double a = distance(from);
    const double b = distance(to);
    if (a >= 0) {
      kept.push_back(from);
    }
    if ((a < 0) != (b < 0)) {
      kept.push_back(from + (to - from) * (a / (a - b)));
    }
  }
  return kept;
}

/// The first brick, and the one after the last, that hold some of [from, to], in cells of a side of `cells`.
struct BrickSpan {
  int first = 0;
  int count = 0;
};

BrickSpan bricksOver(double from, double to, int cells) {
  // A cell more at both ends, for what rounding moves.
  const int first = std::clamp(static_cast<int>(std::floor(from)) - 1, 0, cells - 1) / kSweptBrickSide;
  const int last = std::clamp(static_cast<int>(std::floor(to)) + 1, 0, cells - 1) / kSweptBrickSide;
  return {first, last - first + 1};
}

/// What of the screen a box cuts out, as (r, y), that reaches `margin` farther along each index axis than the volume's.
std::vector<glm::dvec2> boxOnScreen(const SweptPlane& plane, const glm::dvec3& upper, const glm::dvec3& margin,
                                    double halfHeight) {
  std::vector<glm::dvec2> polygon{{-1, -halfHeight}, {1, -halfHeight}, {1, halfHeight}, {-1, halfHeight}};
  for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
    const auto indexAt = [&](const glm::dvec2& p) {
      return plane.origin[axis] + plane.byRadius[axis] * p.x + plane.byHeight[axis] * p.y;
    };
    polygon = clippedOutline(polygon, [&](const glm::dvec2& p) { return indexAt(p) + 0.5 + margin[axis]; });
    polygon = clippedOutline(polygon, [&](const glm::dvec2& p) { return upper[axis] + margin[axis] - indexAt(p); });
  }
  return polygon;
}

}  // namespace

SweptPlane::SweptPlane(const glm::dmat4& indexFromScene, const SweepGeometry& sweep, int slice)
    : origin(indexFromScene[3]) {
  const glm::dvec2& direction = sweep.sectorDirection(slice);
  const glm::dmat3 linear(indexFromScene);
  byRadius = linear * glm::dvec3(direction.x, 0, direction.y);
  byAcross = linear * glm::dvec3(-direction.y, 0, direction.x);
  byHeight = linear * glm::dvec3(0, 1, 0);
}

SweptSlice sweptOutline(const SweptPlane& plane, const glm::dvec3& upper, const SweepGeometry& sweep) {
  // Half of a column and of a row, and half of the thickness of cells: that at the rim, and then that of the farthest
  // ones which the box may cover.
  const glm::dvec3 beside =
      (glm::abs(plane.byRadius) * sweep.columnWidth() + glm::abs(plane.byHeight) * sweep.rowHeight()) / 2.0;
  const glm::dvec3 thickness = glm::abs(plane.byAcross) * sweep.tanHalfStep();
  std::vector<glm::dvec2> polygon = boxOnScreen(plane, upper, beside + thickness, sweep.halfHeight());
  double farthest = 0;
  for (const glm::dvec2& p : polygon) {
    farthest = std::max(farthest, std::abs(p.x) + sweep.columnWidth());
  }
  polygon = boxOnScreen(plane, upper, beside + thickness * std::min(farthest, 1.0), sweep.halfHeight());
  if (polygon.empty()) {
    return {};
  }
  const auto [left, right] = std::ranges::minmax(polygon, {}, &glm::dvec2::x);
  const auto [low, high] = std::ranges::minmax(polygon, {}, &glm::dvec2::y);
  const BrickSpan columns =
      bricksOver((left.x + 1) * sweep.columnsPerRadius(), (right.x + 1) * sweep.columnsPerRadius(), sweep.width());
  const BrickSpan rows = bricksOver(sweep.rowOfY(high.y), sweep.rowOfY(low.y), sweep.height());
  return {columns.first, rows.first, columns.count, rows.count, 0};
}

}  // namespace ocelli
