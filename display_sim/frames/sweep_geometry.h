// Where the voxels of a swept-screen display lie: the one place that holds the convention.
//
// Slice i of N (over a half turn) is the plane through the y axis and d_i = (cos t, 0, sin t), t = i pi / N. Column x
// of W has its centre at the signed distance r = (x + 0.5 - W/2) / (W/2) along d_i, row y of H at height h (1 - (y +
// 0.5) / (H/2)), where h is half the height of the screen (1 for a screen as high as wide). Stored slices N <= i < 2N
// (a profile whose second half turn has its own) continue the same formula: d_(i+N) = -d_i.
//
// A voxel (i, x, y) is a cell of space, faces included: all points p whose angle about the axis lies within half a
// step, pi / 2N, of the plane of slice i (on either side of the axis), whose signed distance p . d_i lies in column x
// and whose height lies in row y. Cells of all slices together fill the volume without a gap. What passes through a
// cell lights it, so that a surface along a slice plane, or between two, is never lost.
//
// The half planes from the axis outwards are the 2N sectors: sector j looks along d_j; its outward points lie in slice
// j mod N, at positive r for j < N and at negative r for the others. Screen coordinates are q = W/2 + (W/2) r to the
// right and v downwards, in pixels: cell (x, y) is [x, x + 1] x [y, y + 1].
#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "display_sim/frames/display_profile.h"

namespace ocelli {

class SweepGeometry {
 public:
  explicit SweepGeometry(const DisplayProfile& profile);

  int slicesPerHalfTurn() const { return slices_; }
  int sectors() const { return 2 * slices_; }
  int width() const { return width_; }
  int height() const { return height_; }

  double stepRadians() const { return step_; }
  /// tan of half a step: a sector holds the points with |across| <= outward * tanHalfStep().
  double tanHalfStep() const { return tanHalfStep_; }
  /// (cos, sin) of the angle of d_j about the y axis, from x towards z; j in [0, 2N).
  const glm::dvec2& sectorDirection(int sector) const { return directions_[static_cast<size_t>(sector)]; }
  int sliceOfSector(int sector) const { return sector < slices_ ? sector : sector - slices_; }
  /// +1 where outward in this sector is to the right in its slice, else -1.
  double sideOfSector(int sector) const { return sector < slices_ ? 1.0 : -1.0; }

  double columnsPerRadius() const { return width_ / 2.0; }
  double columnWidth() const { return 2.0 / width_; }
  double rowHeight() const { return 2.0 * halfHeight_ / height_; }
  double halfHeight() const { return halfHeight_; }
  double columnRadius(int column) const { return (column + 0.5 - width_ / 2.0) / (width_ / 2.0); }
  double rowCenterY(int row) const { return halfHeight_ * (1 - (row + 0.5) / (height_ / 2.0)); }
  /// Screen coordinate v of a height.
  double rowOfY(double y) const { return (1 - y / halfHeight_) * (height_ / 2.0); }

  /// The centre of a voxel in model space; `slice` in [0, 2N).
  glm::dvec3 voxelCenter(int slice, int column, int row) const;

 private:
  int slices_;
  int width_;
  int height_;
  double halfHeight_;
  double step_;
  double tanHalfStep_;
  std::vector<glm::dvec2> directions_;
};

}  // namespace ocelli
