#include "oc_core/camera/epipolar_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// Lines that meet farther away than this are parallel: over a disparity of 100 pixels, at 240 pixels from the axis,
/// they differ by 0.024 pixels.
constexpr double kFarthestEpipolePixels = 1e6;
/// How far a segment may lean out of the rows, of its length: rounding of an eye at 10 units.
constexpr double kMinSlant = 1e-4;

struct Interval {
  double from, to;
};

/// Distances from `origin` at which a ray along `direction` is within [0, size].
std::optional<Interval> within(const glm::dvec2& origin, const glm::dvec2& direction, const glm::dvec2& size) {
  Interval range{0, 1e30};
  for (int axis = 0; axis < 2; ++axis) {
    if (std::abs(direction[axis]) < 1e-15) {
      if (origin[axis] < 0 || origin[axis] > size[axis]) {
        return std::nullopt;
      }
      continue;
    }
    const double a = -origin[axis] / direction[axis];
    const double b = (size[axis] - origin[axis]) / direction[axis];
    range.from = std::max(range.from, std::min(a, b));
    range.to = std::min(range.to, std::max(a, b));
  }
  return range.from < range.to ? std::optional(range) : std::nullopt;
}

double wrapped(double angle) {
  return std::remainder(angle, 2 * kPi);
}

}  // namespace

void validate(const ViewSegment& segment, const std::string& where) {
  const float length = glm::distance(segment.left, segment.right);
  if (!std::isfinite(length)) {
    throw InputError("the view segment has an end that is not finite", where, "give finite numbers");
  }
  if (!(length > 1e-6f)) {
    throw InputError("the view segment has no length", where, "move its ends apart, or use the depth image (di)");
  }
}

EpipolarLines::EpipolarLines(const PinholeCamera& base, const glm::vec3& right) {
  validate(ViewSegment{base.eye(), right}, "view segment");
  const glm::dvec3 step(base.cameraFromWorld(right));
  const double across = std::hypot(step.x, step.y);
  const double focal = base.focalPixels();
  advance_ = step.z;
  parallel_ = std::abs(step.z) * kFarthestEpipolePixels <= focal * across;
  if (parallel_) {
    if (step.x <= 0 || std::abs(step.y) > kMinSlant * across) {
      throw InputError("the view segment is parallel to the image plane, but not to its rows", "view segment",
                       "roll the view (\"up\") until the segment runs to the right");
    }
    disparity_ = focal * across;
    setParallelRows(base);
  } else {
    forward_ = step.z > 0;
    disparity_ = std::abs(step.z);
    epipole_ = glm::dvec2(base.centerPixels()) + focal * glm::dvec2(step) / step.z;
    setRadialRows(base);
  }
  longest_ = std::max(1, *std::max_element(lengths_.begin(), lengths_.end()));
  if (int64_t{rowCount()} * longest_ > PinholeCamera::kMaxPixels) {
    throw InputError("an image with " + std::to_string(rowCount()) + " epipolar lines cannot be made", "view segment",
                     "choose a smaller image, or a segment across the view");
  }
}

void EpipolarLines::setParallelRows(const PinholeCamera& base) {
  starts_.assign(static_cast<size_t>(base.height()), 0);
  lengths_.assign(static_cast<size_t>(base.height()), base.width());
}

void EpipolarLines::setRadialRows(const PinholeCamera& base) {
  const glm::dvec2 size(base.width(), base.height());
  const std::array<glm::dvec2, 4> corners{{{0, 0}, {size.x, 0}, {0, size.y}, size}};
  ring_ = epipole_.x > 0 && epipole_.y > 0 && epipole_.x < size.x && epipole_.y < size.y;
  double farthest = 0;
  double least = 0;
  double most = 0;
  const glm::dvec2 toMiddle = size / 2.0 - epipole_;
  const double middle = std::atan2(toMiddle.y, toMiddle.x);
  for (const glm::dvec2& corner : corners) {
    const glm::dvec2 d = corner - epipole_;
    farthest = std::max(farthest, glm::length(d));
    const double angle = wrapped(std::atan2(d.y, d.x) - middle);
    least = std::min(least, angle);
    most = std::max(most, angle);
  }
  firstAngle_ = ring_ ? 0 : middle + least;
  const double angles = ring_ ? 2 * kPi : most - least;
  const double rows = std::ceil(angles * farthest);
  if (!(rows * farthest < 1e12)) {
    throw InputError("the view segment has too many epipolar lines", "view segment", "choose another segment");
  }
  angleStep_ = angles / rows;
  for (int row = 0; row < static_cast<int>(rows); ++row) {
    const std::optional<Interval> range = within(epipole_, direction(row + 0.5), size);
    const int inner = range ? static_cast<int>(std::floor(range->from)) : 0;
    const int outer = range ? static_cast<int>(std::ceil(range->to)) : 0;
    starts_.push_back(forward_ ? outer : inner);
    lengths_.push_back(outer - inner);
  }
}

int EpipolarLines::rowOf(double row) const {
  const double floored = std::floor(row);
  if (ring_) {
    const double turn = floored - rowCount() * std::floor(floored / rowCount());
    return std::clamp(static_cast<int>(turn), 0, rowCount() - 1);
  }
  return static_cast<int>(std::clamp(floored, 0.0, rowCount() - 1.0));
}

glm::dvec2 EpipolarLines::direction(double row) const {
  const double angle = firstAngle_ + row * angleStep_;
  return {std::cos(angle), std::sin(angle)};
}

EpipolarLines::Place EpipolarLines::place(const glm::dvec2& imagePoint) const {
  if (parallel_) {
    return {imagePoint.y, imagePoint.x};
  }
  const glm::dvec2 d = imagePoint - epipole_;
  // Angles are taken from the middle of the rows, so that the cut between -pi and pi lies opposite to them.
  const double half = angleStep_ * rowCount() / 2;
  const double row = (wrapped(std::atan2(d.y, d.x) - firstAngle_ - half) + half) / angleStep_;
  return {row, positionAtRadius(rowOf(row), glm::length(d))};
}

glm::dvec2 EpipolarLines::imagePoint(const Place& place) const {
  if (parallel_) {
    return {place.position, place.row};
  }
  return epipole_ + direction(place.row) * radius(rowOf(place.row), place.position);
}

}  // namespace ocelli
