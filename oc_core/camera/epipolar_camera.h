// The epipolar occlusion camera (EOC, section 3.3): samples what a pinhole sees while its eye moves along a segment LR,
// in one layer.
//
// Each row is an epipolar line (epipolar_lines.h). It holds the rays of the base pinhole at L, and at each place where
// the line steps off an occluder some more, which run under the occluder: as rays of R down to the depth of the
// background, then as rays of L (the pairs r_R, r_L of 3.3.1.1). Rows grow by themselves; the image is as wide as its
// widest row.
//
// In the coordinates x, y of epipolar_lines.h an edge e at x_e, whose occluder has y_n, makes a disocclusion region:
// what L does not see but is seen past e from somewhere on the segment, x - D y > x_e - D y_n, with x between where the
// disocclusion is clipped and x_e. A point in several disocclusions belongs to the rightmost edge. Its column is that
// of the point
//     x' = x - D max(0, y - y_f)
// moved by all columns that were added up to that edge; a point in no disocclusion is moved by those added before it. A
// row is so a bijection between columns and what it samples.
//
// DEVIATION: the model is held as the list of edges of each row, instead of the maps PM and RM, which follow from it
// (tests/camera/epipolar_maps_test.cpp builds both from the text). PM stores two offsets and two depths a pixel and
// brackets a projection; the list gives it exactly, also where disocclusions overlap.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "oc_core/camera/camera.h"
#include "oc_core/camera/epipolar_lines.h"
#include "oc_core/camera/pinhole_camera.h"

namespace ocelli {

/// A depth discontinuity of a row of the base image, near before and far behind it. Its disocclusion reaches from the
/// centre of base pixel `clip` to that of base pixel `position`, the first one behind the occluder: where between the
/// two rays of L the occluder ends is not known, and what curves away there is seen from R. It reaches no farther than
/// the columns that it adds.
struct EpipolarEdge {
  int position = 0;       ///< the border between base pixels where the occluder ends
  int clip = 0;           ///< the first base pixel in its disocclusion, below `position`
  int added = 0;          ///< columns that make room for the disocclusion, at least 1
  float inverseNear = 0;  ///< 1/z of the occluder
};

class EpipolarCamera {
 public:
  /// An edge with what follows from it.
  struct Disocclusion {
    int position = 0;
    int clip = 0;
    int added = 0;
    int shift = 0;      ///< columns added up to this edge
    double xRight = 0;  ///< x - D y_n: where R sees the edge
    double yFar = 0;    ///< y_f: rays of R above, rays of L below
  };
  /// A ray in the plane of its row: x = xFar + D max(0, y - yFar), where yEnd < y < yStart. Straight rays have an
  /// infinite yFar.
  struct PlaneRay {
    double xFar = 0;
    double yFar = 0;
    double yStart = 0;
    double yEnd = 0;
  };

  /// The eye of `base` is L, `right` is R; one list of edges a row of EpipolarLines(base, right), from left to right.
  /// Throws InputError where EpipolarLines does, and where the columns are more than an image may have.
  EpipolarCamera(const PinholeCamera& base, const glm::vec3& right,
                 const std::vector<std::vector<EpipolarEdge>>& rowEdges);

  int width() const { return width_; }
  int height() const { return lines_.rowCount(); }
  const PinholeCamera& base() const { return base_; }
  const EpipolarLines& lines() const { return lines_; }

  std::optional<ImagePoint> project(const glm::vec3& worldPoint) const;
  std::optional<glm::vec3> unproject(const ImagePoint& q) const;
  RayPath rayPath(const glm::vec2& pixel) const;

  /// The edges of a row, from left to right.
  std::span<const Disocclusion> disocclusions(int row) const;
  /// A row falls into cells between the centres of base pixels, for k from 0 to the row's length: cell k begins just
  /// before the centre of base pixel k - 1, so that rounding does not move that centre out of it. A disocclusion covers
  /// whole cells.
  static int cellOf(double position) { return static_cast<int>(position - cellBegin(0)); }
  static double cellBegin(int cell) { return cell - 0.51; }
  int cellCount(int row) const { return lines_.length(row) + 1; }
  /// Those whose disocclusions lie over a cell and can win there, from right to left: xRight falls.
  std::span<const uint32_t> disocclusionsOver(int row, int cell) const;
  /// The disocclusion that a point over a cell is in, given its x - D y; nullptr for none.
  const Disocclusion* disocclusionOf(int row, int cell, double xRight) const;
  /// Columns that are added before a base position on a row.
  int shiftAt(int row, double position) const;
  /// Columns of a row; the image may be wider.
  int rowWidth(int row) const;
  /// Nothing for columns that were added and whose ray runs within other disocclusions, and those beyond the row's own
  /// width.
  std::optional<PlaneRay> planeRay(int row, double column) const;

 private:
  PlaneRay straightRay(int row, double position) const;
  std::optional<PlaneRay> bentRay(int row, const Disocclusion& disocclusion, double position) const;
  /// The base image point on a row, at x and y.
  ImagePoint basePoint(double row, double x, double y) const;

  PinholeCamera base_;
  EpipolarLines lines_;
  int width_ = 1;
  std::vector<size_t> rowFirst_;  ///< in disocclusions_
  std::vector<Disocclusion> disocclusions_;
  std::vector<uint32_t> overFirst_;  ///< in over_, for each cell of each row
  std::vector<uint32_t> over_;       ///< indices of disocclusions within their row
};

static_assert(Camera<EpipolarCamera>);

/// As for cameras that displace the image of a pinhole (distorted_pinhole.h): the one that z is measured along.
inline const PinholeCamera& referenceOf(const EpipolarCamera& camera) {
  return camera.base();
}

}  // namespace ocelli
