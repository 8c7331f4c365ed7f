#include "oc_core/isosurface/surface_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// Differences over `reach` voxels each way.
glm::dvec3 differences(const ScalarVolume& volume, const glm::dvec3& index, double reach) {
  const glm::dvec3 last(volume.grid().size - 1);
  glm::dvec3 gradient(0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 before = index;
    glm::dvec3 behind = index;
    before[axis] = std::clamp(index[axis] - reach, 0.0, last[axis]);
    behind[axis] = std::clamp(index[axis] + reach, 0.0, last[axis]);
    const double length = behind[axis] - before[axis];
    gradient[axis] = length > 0 ? (volume.fieldAt(behind) - volume.fieldAt(before)) / length : 0;
  }
  return gradient;
}

/// Newton's method along the gradient of the interpolated field. The field has kinks where cells meet, so a step may
/// fail: the nearest of all that were tried counts.
glm::dvec3 fitted(const glm::dvec3& start, const ScalarVolume& volume, double value) {
  constexpr int kMaxSteps = 4;
  constexpr double kReach = 1e-3;    // voxels: within one cell, nearly always
  constexpr double kFarthest = 0.5;  // voxels along an axis
  constexpr double kLongestStep = 0.25;
  const glm::dvec3 last(volume.grid().size - 1);
  const glm::dvec3 lower = glm::max(start - kFarthest, glm::dvec3(0));
  const glm::dvec3 upper = glm::min(start + kFarthest, last);
  glm::dvec3 best = start;
  glm::dvec3 at = start;
  double miss = volume.fieldAt(at) - value;
  double leastMiss = std::abs(miss);
  for (int step = 0; step < kMaxSteps && leastMiss > 0; ++step) {
    const glm::dvec3 gradient = differences(volume, at, kReach);
    const double slope2 = glm::dot(gradient, gradient);
    if (!(slope2 > 0)) {
      break;
    }
    const glm::dvec3 move = -gradient * (miss / slope2);
    const double length = glm::length(move);
    at = glm::clamp(at + (length > kLongestStep ? move * (kLongestStep / length) : move), lower, upper);
    miss = volume.fieldAt(at) - value;
    if (std::abs(miss) < leastMiss) {
      leastMiss = std::abs(miss);
      best = at;
    }
  }
  return best;
}

}  // namespace

glm::dvec3 indexGradient(const ScalarVolume& volume, const glm::dvec3& index) {
  return differences(volume, index, 1);
}

bool isBetweenCenters(const VolumeGrid& grid, const glm::dvec3& index) {
  return glm::all(glm::greaterThanEqual(index, glm::dvec3(0))) &&
         glm::all(glm::lessThanEqual(index, glm::dvec3(grid.size - 1)));
}

void fitToField(std::vector<glm::vec3>& points, const ScalarVolume& volume, double value) {
  parallelFor(points.size(), 1 << 10, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (isBetweenCenters(volume.grid(), points[i])) {
        points[i] = glm::vec3(fitted(points[i], volume, value));
      }
    }
  });
}

}  // namespace ocelli
