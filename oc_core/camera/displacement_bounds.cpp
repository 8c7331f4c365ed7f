#include "oc_core/camera/displacement_bounds.h"

namespace ocelli {
namespace {

constexpr int kFinestCell = 4;  ///< pixels a side

using Range = DisplacementBounds::Range;

Range rangeOf(const DistortionSample& sample) {
  Range range{{glm::min(sample.displacement, glm::vec2(0)), glm::max(sample.displacement, glm::vec2(0))},
              sample.inverseNear,
              sample.inverseNear,
              sample.inverseFar,
              sample.inverseFar};
  if (sample.displacement != glm::vec2(0)) {
    range.rampLower = sample.inverseFar;
    range.rampUpper = sample.inverseNear;
  }
  return range;
}

void join(Range& range, const Range& other) {
  range.displacement.lower = glm::min(range.displacement.lower, other.displacement.lower);
  range.displacement.upper = glm::max(range.displacement.upper, other.displacement.upper);
  range.minInverseNear = std::min(range.minInverseNear, other.minInverseNear);
  range.greatestInverseNear = std::max(range.greatestInverseNear, other.greatestInverseNear);
  range.minInverseFar = std::min(range.minInverseFar, other.minInverseFar);
  range.greatestInverseFar = std::max(range.greatestInverseFar, other.greatestInverseFar);
  if (range.rampUpper < range.rampLower) {
    range.rampLower = other.rampLower;
    range.rampUpper = other.rampUpper;
  } else if (other.rampUpper >= other.rampLower) {
    range.rampLower = std::min(range.rampLower, other.rampLower);
    range.rampUpper = std::max(range.rampUpper, other.rampUpper);
  }
}

/// One cell for each `cell` x `cell` elements of `fine`, which `rangeOfElement` turns into ranges.
template <class Element, class ToRange>
Image<Range> coarser(const Image<Element>& fine, int cell, const ToRange& rangeOfElement) {
  Image<Range> coarse((fine.width() + cell - 1) / cell, (fine.height() + cell - 1) / cell);
  for (int y = 0; y < fine.height(); ++y) {
    for (int x = 0; x < fine.width(); ++x) {
      Range& range = coarse(x / cell, y / cell);
      if (x % cell == 0 && y % cell == 0) {
        range = rangeOfElement(fine(x, y));
      } else {
        join(range, rangeOfElement(fine(x, y)));
      }
    }
  }
  return coarse;
}

/// Equation 3.3 for samples with 1/z_n in [minNear, greatestNear] and 1/z_f in [minFar, greatestFar]. The ramp
/// grows with both of them, and falls with 1/z.
float greatestRamp(const Range& range, float inverseZ) {
  if (inverseZ >= range.greatestInverseNear) {
    return 0;
  }
  return inverseZ <= range.greatestInverseFar
             ? 1
             : (range.greatestInverseNear - inverseZ) / (range.greatestInverseNear - range.greatestInverseFar);
}
float minRamp(const Range& range, float inverseZ) {
  // A sample whose z_n is not before its z_f displaces nothing.
  if (inverseZ >= range.minInverseNear || range.minInverseNear <= range.greatestInverseFar) {
    return 0;
  }
  return inverseZ <= range.minInverseFar
             ? 1
             : (range.minInverseNear - inverseZ) / (range.minInverseNear - range.minInverseFar);
}

}  // namespace

ImageBox DisplacementBounds::Range::at(float minInverseZ, float greatestInverseZ) const {
  return scaled(displacement, minRamp(*this, greatestInverseZ), greatestRamp(*this, minInverseZ));
}

DisplacementBounds::DisplacementBounds(const DistortionMap& map) {
  levels_.push_back(coarser(map.samples(), kFinestCell, rangeOf));
  while (levels_.back().width() > 1 || levels_.back().height() > 1) {
    levels_.push_back(coarser(levels_.back(), 2, [](const Range& range) { return range; }));
  }
}

Range DisplacementBounds::over(const ImageBox& undistorted) const {
  // A bilinear lookup takes the samples around a point, the nearest one lies half a pixel away: one pixel holds both.
  // Cells of the level chosen are no shorter than half the box.
  const glm::vec2 lower = undistorted.lower - 1.0f;
  const glm::vec2 upper = undistorted.upper + 1.0f;
  const float side = std::max(upper.x - lower.x, upper.y - lower.y);
  size_t level = 0;
  float cell = kFinestCell;
  while (level + 1 < levels_.size() && cell * 2 < side) {
    ++level;
    cell *= 2;
  }
  const Image<Range>& cells = levels_[level];
  const auto index = [cell](float coordinate, int count) {
    return static_cast<int>(std::clamp(std::floor(coordinate / cell), 0.0f, static_cast<float>(count - 1)));
  };
  const int x0 = index(lower.x, cells.width());
  const int x1 = index(upper.x, cells.width());
  const int y0 = index(lower.y, cells.height());
  const int y1 = index(upper.y, cells.height());
  Range range = cells(x0, y0);
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      join(range, cells(x, y));
    }
  }
  return range;
}

}  // namespace ocelli
