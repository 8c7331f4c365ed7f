// Epipolar lines (section 3.3): the lines along which a pinhole's image moves while its eye moves along a segment.
//
// The rows of an epipolar occlusion camera are the lines that a view segment LR induces in the image of the base
// pinhole at L. Where LR is parallel to the image plane they are its pixel rows. Where LR has a component along the
// view they meet in the epipole, the image of LR's direction: rows are angles around it (Figure 3.18), as many as give
// each pixel at the image border its own.
//
// Along a line every case is the same problem in two dimensions. With w = 1/z, and r the distance from the epipole in
// pixels, there are coordinates
//     x = u,     y = w       parallel
//     x = 1/r,   y = w / r   R in front of L; positions run towards the epipole
//     x = -1/r,  y = w / r   R behind L; positions run away from it
// in which a point moves by x(t) = x - t D y on the way from L (t = 0) to R (t = 1), where D, the disparity, is f |LR|
// or the component of LR along the view. x grows with the position along the line.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "oc_core/camera/pinhole_camera.h"

namespace ocelli {

/// Viewpoints from `left` to `right`, world points: "left" is where the base pinhole stands.
struct ViewSegment {
  glm::vec3 left{0};
  glm::vec3 right{0};
};

/// Throws InputError where an end is not finite or the two coincide.
void validate(const ViewSegment& segment, const std::string& where);

class EpipolarLines {
 public:
  /// A place on a line: the row's coordinate as that of an image (row i from i to i + 1) and base pixels along it.
  struct Place {
    double row = 0;
    double position = 0;
  };

  /// `right` is the world point R; the eye of `base` is L. A segment parallel to the image plane must run along the
  /// rows of `base`, to the right: roll the view for others. Throws InputError where it does not, or is no segment, or
  /// would take more rows than an image may have.
  EpipolarLines(const PinholeCamera& base, const glm::vec3& right);

  int rowCount() const { return static_cast<int>(starts_.size()); }
  /// The epipole lies in the image: the last row is next to the first.
  bool isRing() const { return ring_; }
  bool isParallel() const { return parallel_; }
  /// Base pixels on a row: pixel j reaches from position j to j + 1.
  int length(int row) const { return lengths_[static_cast<size_t>(row)]; }
  int longest() const { return longest_; }
  /// The row that a coordinate falls in; the first or last one where it is out of the image.
  int rowOf(double row) const;

  Place place(const glm::dvec2& imagePoint) const;
  glm::dvec2 imagePoint(const Place& place) const;
  /// The epipole in the base image, pixels, and the direction of a line there. Only where lines are radial.
  const glm::dvec2& epipole() const { return epipole_; }
  glm::dvec2 direction(double row) const;
  /// Angle of the first row's border and that of a row, radians. Only where lines are radial.
  double firstAngle() const { return firstAngle_; }
  double angleStep() const { return angleStep_; }
  /// Distance of position 0 of a row from the epipole, pixels; 0 where lines are parallel.
  int start(int row) const { return starts_[static_cast<size_t>(row)]; }
  bool isForward() const { return forward_; }
  /// Position on a row at a distance from the epipole.
  double positionAtRadius(int row, double radius) const {
    const double start = starts_[static_cast<size_t>(row)];
    return forward_ ? start - radius : radius - start;
  }
  double radius(int row, double position) const {
    const double start = starts_[static_cast<size_t>(row)];
    return forward_ ? start - position : start + position;
  }

  double disparity() const { return disparity_; }
  /// How far R is in front of L along the view; negative behind.
  double advance() const { return advance_; }
  /// Whether a line has this position: it ends at the epipole.
  bool has(int row, double position) const { return parallel_ || radius(row, position) > 0; }
  double x(int row, double position) const {
    return parallel_ ? position : (forward_ ? 1 : -1) / radius(row, position);
  }
  double position(int row, double x) const { return parallel_ ? x : positionAtRadius(row, (forward_ ? 1 : -1) / x); }
  /// y for each 1/z, at x.
  double inverseZScale(double x) const { return parallel_ ? 1 : forward_ ? x : -x; }

  bool operator==(const EpipolarLines&) const = default;

 private:
  void setParallelRows(const PinholeCamera& base);
  void setRadialRows(const PinholeCamera& base);

  bool parallel_ = true;
  bool forward_ = true;
  bool ring_ = false;
  double disparity_ = 0;
  double advance_ = 0;
  glm::dvec2 epipole_{0};
  double firstAngle_ = 0;  ///< of the border of row 0
  double angleStep_ = 0;
  int longest_ = 0;
  std::vector<int> starts_;  ///< distance of position 0 from the epipole, pixels
  std::vector<int> lengths_;
};

}  // namespace ocelli
