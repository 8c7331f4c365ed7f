#include "oc_core/isosurface/surface_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// The slope of the interpolated field, by index coordinates. Zero across the faces of the box.
glm::dvec3 slopeAt(const ScalarVolume& volume, const glm::dvec3& index) {
  constexpr double kReach = 1e-3;  // voxels: within one cell, nearly always
  const glm::dvec3 last(volume.grid().size - 1);
  glm::dvec3 gradient(0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 before = index;
    glm::dvec3 behind = index;
    before[axis] = std::clamp(index[axis] - kReach, 0.0, last[axis]);
    behind[axis] = std::clamp(index[axis] + kReach, 0.0, last[axis]);
    const double length = behind[axis] - before[axis];
    gradient[axis] = length > 0 ? (volume.fieldAt(behind) - volume.fieldAt(before)) / length : 0;
  }
  return gradient;
}

/// Whether the surface runs through the cell of voxel centres that a point lies in, or beside: not where the faces of
/// the box alone close it.
bool isOnSurface(const ScalarVolume& volume, const glm::dvec3& point, double value) {
  const glm::ivec3 last = volume.grid().size - 1;
  const glm::ivec3 cell(glm::floor(point));
  bool isAnyAbove = false;
  bool isAnyBelow = false;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 voxel = cell + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
    (volume.valueAt(glm::clamp(voxel, glm::ivec3(0), last)) > value ? isAnyAbove : isAnyBelow) = true;
  }
  return isAnyAbove && isAnyBelow;
}

/// Coordinates beyond the outermost centres go to the faces of the box: those are where the extractor has rounded the
/// edges off that the faces make.
glm::dvec3 onFaces(const VolumeGrid& grid, glm::dvec3 point) {
  const glm::dvec3 last(grid.size - 1);
  for (int axis = 0; axis < 3; ++axis) {
    if (point[axis] < 0 || point[axis] > last[axis]) {
      point[axis] = point[axis] < 0 ? -0.5 : last[axis] + 0.5;
    }
  }
  return point;
}

/// Newton's method along the gradient of the interpolated field, which is zero across the faces of the box. The field
/// has kinks where cells meet, so a step may fail: the nearest of all that were tried counts.
glm::dvec3 fitted(const glm::dvec3& start, const ScalarVolume& volume, double value) {
  constexpr int kMaxSteps = 8;
  constexpr double kMaxMove = 0.5;  // voxels along an axis
  constexpr double kMaxStep = 0.25;
  const glm::dvec3 last(volume.grid().size - 1);
  const glm::dvec3 lower = glm::min(glm::max(start - kMaxMove, glm::dvec3(0)), start);
  const glm::dvec3 upper = glm::max(glm::min(start + kMaxMove, last), start);
  glm::dvec3 best = start;
  glm::dvec3 at = start;
  double miss = volume.fieldAt(at) - value;
  double leastMiss = std::abs(miss);
  for (int step = 0; step < kMaxSteps && leastMiss > 0; ++step) {
    const glm::dvec3 gradient = slopeAt(volume, at);
    const double slope2 = glm::dot(gradient, gradient);
    if (!(slope2 > 0)) {
      break;
    }
    const glm::dvec3 move = -gradient * (miss / slope2);
    const double length = glm::length(move);
    at = glm::clamp(at + (length > kMaxStep ? move * (kMaxStep / length) : move), lower, upper);
    miss = volume.fieldAt(at) - value;
    if (std::abs(miss) < leastMiss) {
      leastMiss = std::abs(miss);
      best = at;
    }
  }
  return best;
}

}  // namespace

bool isBetweenCenters(const VolumeGrid& grid, const glm::dvec3& index) {
  return glm::all(glm::greaterThanEqual(index, glm::dvec3(0))) &&
         glm::all(glm::lessThanEqual(index, glm::dvec3(grid.size - 1)));
}

void fitToField(std::vector<glm::vec3>& points, const ScalarVolume& volume, double value) {
  parallelFor(points.size(), 1 << 10, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::dvec3 start = onFaces(volume.grid(), points[i]);
      points[i] = glm::vec3(isOnSurface(volume, points[i], value) ? fitted(start, volume, value) : start);
    }
  });
}

}  // namespace ocelli
