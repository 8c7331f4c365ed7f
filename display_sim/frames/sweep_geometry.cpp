#include "display_sim/frames/sweep_geometry.h"

#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"

namespace ocelli {

SweepGeometry::SweepGeometry(const DisplayProfile& profile)
    : slices_(profile.slicesPerHalfTurn),
      width_(profile.width),
      height_(profile.height),
      halfHeight_(profile.halfHeightRadii),
      step_(kPi / profile.slicesPerHalfTurn),
      tanHalfStep_(std::tan(step_ / 2)) {
  OC_CHECK(slices_ >= 2 && width_ >= 2 && height_ >= 1 && halfHeight_ > 0, "the display profile was not validated");
  directions_.resize(static_cast<size_t>(sectors()));
  for (int j = 0; j < slices_; ++j) {
    // cos(pi / 2) is not 0 in floating point, yet a quarter turn must be exact: surfaces along the axes are common.
    const bool quarter = 2 * j == slices_;
    const glm::dvec2 direction = quarter ? glm::dvec2(0, 1) : glm::dvec2(std::cos(j * step_), std::sin(j * step_));
    directions_[static_cast<size_t>(j)] = direction;
    directions_[static_cast<size_t>(j + slices_)] = -direction;
  }
}

glm::dvec3 SweepGeometry::voxelCenter(int slice, int column, int row) const {
  const double r = columnRadius(column);
  const glm::dvec2& direction = sectorDirection(slice);
  return {r * direction.x, rowCenterY(row), r * direction.y};
}

}  // namespace ocelli
