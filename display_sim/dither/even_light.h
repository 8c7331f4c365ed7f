// Light for the area of a surface, and weights that make it even.
//
// Every lit voxel of a sweep emits the same light, but voxels are not of the same size: with columns a wide, rows b
// high and c = r step deep at the distance r from the axis, those near the axis are small. A surface with the unit
// normal n (parts n_r away from the axis, n_y along it, n_t around it) lights every cell that it passes through. A cell
// is met by a plane iff its centre lies within half of a |n_r| + b |n_y| + c |n_t| of it, and there is one centre
// for each volume a b c, so an area has
//
//     D(r, n) = (|n_r| / b + |n_y| / a) / c + |n_t| / (a b)
//
// lit cells. Surfaces around the axis and across it get brighter as 1 / r, those that contain the axis don't. With a
// weight of T / D, where T is the least D of any direction at the radius R, all surfaces within R give the light T for
// their area; beyond R the weight is min(1, T / D). Light lost: that above T.
//
// Several samples of a surface that fall in one voxel need no more: each is weighed alike, and the voxel is lit once.
// Surfaces that meet within a voxel show the brightest of them, as without weights.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "display_sim/frames/sweep_geometry.h"

namespace ocelli {

/// Of a surface in one slice: its weight at the distance r from the axis is min(1, r / (across + around r)).
struct EvenLightFacing {
  float across = 0;
  float around = 0;
};

/// `radius`: of the voxel's centre, in display radii, above 0 (EvenLight::columnRadius()).
inline float evenLightWeight(const EvenLightFacing& facing, float radius) {
  return radius / std::max(radius, facing.across + facing.around * radius);
}

/// Upward for a triangle without area.
inline glm::dvec3 unitNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::dvec3 normal = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
  const double length = glm::length(normal);
  return length > 0 ? normal / length : glm::dvec3(0, 1, 0);
}

class EvenLight {
 public:
  /// Of cells of the first half turn; the second half turn's have the same weights. `radius` above 0.
  EvenLight(const SweepGeometry& sweep, double radius) : sweep_(&sweep) {
    const double column = sweep.columnWidth();
    const double row = sweep.rowHeight();
    const double arc = radius * sweep.stepRadians();
    const double even = 1 / std::max({row * arc, column * arc, column * row});
    fromOutward_ = 1 / (row * sweep.stepRadians() * even);
    fromUpward_ = 1 / (column * sweep.stepRadians() * even);
    fromAround_ = 1 / (column * row * even);
  }

  EvenLightFacing facing(const glm::dvec3& unitNormal, int slice) const {
    const glm::dvec3& n = unitNormal;
    const glm::dvec2& direction = sweep_->sectorDirection(slice);
    const double outward = std::abs(n.x * direction.x + n.z * direction.y);
    const double around = std::abs(n.z * direction.x - n.x * direction.y);
    return {static_cast<float>(outward * fromOutward_ + std::abs(n.y) * fromUpward_),
            static_cast<float>(around * fromAround_)};
  }

  /// Distance of a column's centre from the axis; of a column that holds the axis, that of its halves' centres.
  static float columnRadius(const SweepGeometry& sweep, int column) {
    return static_cast<float>(std::max(std::abs(sweep.columnRadius(column)), sweep.columnWidth() / 4));
  }

 private:
  const SweepGeometry* sweep_;
  double fromOutward_;
  double fromUpward_;
  double fromAround_;
};

/// Lit cells for the area (in display radii squared) of a surface with this unit normal, given in the directions away
/// from the axis, along it and around it, at the distance `radius` from it: D(r, n) above.
inline double litCellsPerArea(const SweepGeometry& sweep, const glm::dvec3& normal, double radius) {
  const double arc = radius * sweep.stepRadians();
  return (std::abs(normal.x) / sweep.rowHeight() + std::abs(normal.y) / sweep.columnWidth()) / arc +
         std::abs(normal.z) / (sweep.columnWidth() * sweep.rowHeight());
}

}  // namespace ocelli
