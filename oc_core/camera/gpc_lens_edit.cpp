#include "oc_core/camera/gpc_lens_edit.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "oc_core/base/check.h"
#include "oc_core/camera/gpc_fold.h"

namespace ocelli {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

GpcRegion& lensOf(GpcLayout& layout, size_t lens) {
  OC_CHECK(lens < layout.regions.size(), "an index is that of a lens");
  return layout.regions[lens];
}

std::vector<LensBox> boxesOfOthers(const GpcLayout& layout, size_t lens) {
  std::vector<LensBox> boxes;
  for (size_t i = 0; i < layout.regions.size(); ++i) {
    if (i != lens) {
      boxes.push_back(lensBox(layout.regions[i]));
    }
  }
  return boxes;
}

/// Half of what a lens takes up.
glm::dvec2 outerHalfOf(const GpcRegion& lens) {
  return glm::dvec2(lens.extent) / 2.0 * lens.outer();
}

/// Where the centre of a lens may lie within the image. A lens as wide as the image has one place.
LensBox roomForCenter(const glm::dvec2& outerHalf) {
  const glm::dvec2 lower = glm::min(outerHalf, 0.5);
  return {lower, 1.0 - lower};
}

std::optional<glm::dvec2> nearestCenter(const GpcLayout& layout, size_t lens, const glm::dvec2& outerHalf,
                                        const glm::dvec2& wanted, const glm::dvec2& size) {
  std::vector<LensBox> taken = boxesOfOthers(layout, lens);
  for (LensBox& box : taken) {
    box = {box.lower - outerHalf, box.upper + outerHalf};
  }
  return nearestFreePoint(wanted, roomForCenter(outerHalf), taken, size);
}

/// A lens that grows from a fixed place: what it takes up along an axis reaches from `from - extent * before` to
/// `from + extent * after`.
struct Growth {
  glm::dvec2 from;
  glm::dvec2 before;
  glm::dvec2 after;

  /// The greatest extent along an axis with which it does not reach beyond `lower` below, or `upper` above.
  double maxWithin(int axis, double lower, double upper) const {
    return std::min((from[axis] - lower) / before[axis], (upper - from[axis]) / after[axis]);
  }
  /// The greatest extent along an axis with which it lies beside a box; 0 where it never does.
  double maxBeside(int axis, const LensBox& box) const {
    return box.lower[axis] >= from[axis]   ? (box.lower[axis] - from[axis]) / after[axis]
           : box.upper[axis] <= from[axis] ? (from[axis] - box.upper[axis]) / before[axis]
                                           : 0;
  }
};

/// The extents nearest to `wanted`: beside each other lens along one axis at least. Nothing where there are none.
std::optional<glm::dvec2> nearestExtent(const GpcLayout& layout, size_t lens, const Growth& growth,
                                        const glm::dvec2& wanted, const glm::dvec2& size) {
  LensBox room;
  for (int axis = 0; axis < 2; ++axis) {
    room.upper[axis] = std::min(growth.maxWithin(axis, 0, 1), 1.0);
    const auto now = static_cast<double>(layout.regions[lens].extent[axis]);
    room.lower[axis] = std::min({kMinLensExtent, now, room.upper[axis]});
  }
  std::vector<LensBox> taken;
  for (const LensBox& box : boxesOfOthers(layout, lens)) {
    taken.push_back({{growth.maxBeside(0, box), growth.maxBeside(1, box)}, glm::dvec2(kInfinite)});
  }
  return nearestFreePoint(wanted, room, taken, size);
}

glm::dvec2 directionOf(LensCorner corner) {
  const bool isRight = corner == LensCorner::kTopRight || corner == LensCorner::kBottomRight;
  const bool isLow = corner == LensCorner::kBottomLeft || corner == LensCorner::kBottomRight;
  return {isRight ? 1 : -1, isLow ? 1 : -1};
}

/// The greatest `outer` for which a lens has room.
double maxOuter(const GpcLayout& layout, size_t lens) {
  const GpcRegion& region = layout.regions[lens];
  const Growth growth{glm::dvec2(region.center), glm::dvec2(region.extent) / 2.0, glm::dvec2(region.extent) / 2.0};
  double outer = std::min(growth.maxWithin(0, 0, 1), growth.maxWithin(1, 0, 1));
  for (const LensBox& box : boxesOfOthers(layout, lens)) {
    outer = std::min(outer, std::max(growth.maxBeside(0, box), growth.maxBeside(1, box)));
  }
  return outer;
}

bool folds(const GpcLayout& layout, float zoom, double outer) {
  return !GpcProfile(*layout.sampling, static_cast<double>(zoom), outer).isIncreasing();
}

/// The smallest transition width that does not fold, where that of the lens does not.
double minWidth(const GpcLayout& layout, const GpcRegion& lens) {
  double folding = GpcRegion::kMinTransition;
  if (!folds(layout, lens.zoom, 1 + folding)) {
    return folding;
  }
  auto works = static_cast<double>(lens.transitionWidth);
  for (int i = 0; i < 60; ++i) {
    const double middle = (folding + works) / 2;
    (folds(layout, lens.zoom, 1 + middle) ? folding : works) = middle;
  }
  return works;
}

float unfolded(const GpcLayout& layout, double zoom, double outer) {
  const double least = std::max(leastUnfoldedZoom(*layout.sampling, outer), GpcRegion::kMinZoom);
  auto result = static_cast<float>(std::clamp(zoom, least, GpcRegion::kMaxZoom));
  while (folds(layout, result, outer)) {  // rounded down
    result = std::nextafter(result, 2.0f);
  }
  return result;
}

}  // namespace

LensBox lensBox(const GpcRegion& lens) {
  const glm::dvec2 half = outerHalfOf(lens);
  return {glm::dvec2(lens.center) - half, glm::dvec2(lens.center) + half};
}

LensBox lensInnerBox(const GpcRegion& lens) {
  const glm::dvec2 half = glm::dvec2(lens.extent) / 2.0;
  return {glm::dvec2(lens.center) - half, glm::dvec2(lens.center) + half};
}

void moveLens(GpcLayout& layout, size_t lens, const glm::dvec2& wanted, const glm::dvec2& size) {
  GpcRegion& region = lensOf(layout, lens);
  if (const auto center = nearestCenter(layout, lens, outerHalfOf(region), wanted, size)) {
    region.center = glm::vec2(*center);
  }
}

glm::dvec2 cornerOf(const GpcRegion& lens, LensCorner corner) {
  return glm::dvec2(lens.center) + directionOf(corner) * glm::dvec2(lens.extent) / 2.0;
}

void dragLensCorner(GpcLayout& layout, size_t lens, LensCorner corner, const glm::dvec2& wanted,
                    const glm::dvec2& size) {
  GpcRegion& region = lensOf(layout, lens);
  const glm::dvec2 direction = directionOf(corner);
  const glm::dvec2 fixed = glm::dvec2(region.center) - direction * glm::dvec2(region.extent) / 2.0;
  // The transition reaches beyond both corners, by its width in halves of the extent.
  const double beyond = static_cast<double>(region.transitionWidth) / 2;
  Growth growth{fixed, glm::dvec2(beyond), glm::dvec2(beyond)};
  for (int axis = 0; axis < 2; ++axis) {
    (direction[axis] > 0 ? growth.after : growth.before)[axis] += 1;
  }
  if (const auto extent = nearestExtent(layout, lens, growth, (wanted - fixed) * direction, size)) {
    region.extent = glm::vec2(*extent);
    region.center = glm::vec2(fixed + direction * *extent / 2.0);
  }
}

void sizeLens(GpcLayout& layout, size_t lens, const glm::dvec2& wanted, const glm::dvec2& size) {
  GpcRegion& region = lensOf(layout, lens);
  const glm::dvec2 reach(region.outer() / 2);
  if (const auto extent = nearestExtent(layout, lens, {glm::dvec2(region.center), reach, reach}, wanted, size)) {
    region.extent = glm::vec2(*extent);
  }
}

void zoomLens(GpcLayout& layout, size_t lens, double wanted) {
  GpcRegion& region = lensOf(layout, lens);
  region.zoom = unfolded(layout, wanted, region.outer());
}

void widenLens(GpcLayout& layout, size_t lens, double wanted) {
  GpcRegion& region = lensOf(layout, lens);
  const double lower = minWidth(layout, region);
  const double upper = std::min(maxOuter(layout, lens) - 1, GpcRegion::kMaxTransition);
  if (upper < lower) {  // it fits exactly, but for rounding
    return;
  }
  region.transitionWidth = static_cast<float>(std::clamp(wanted, lower, upper));
  if (folds(layout, region.zoom, region.outer())) {  // rounded down
    region.transitionWidth = std::nextafter(region.transitionWidth, static_cast<float>(GpcRegion::kMaxTransition));
  }
}

void setLensSampling(GpcLayout& layout, const GpcSampling& sampling) {
  layout.sampling = &sampling;
  for (GpcRegion& region : layout.regions) {
    region.zoom = unfolded(layout, static_cast<double>(region.zoom), region.outer());
  }
}

std::optional<size_t> addLens(GpcLayout& layout, const GpcRegion& wanted, const glm::dvec2& size) {
  if (layout.regions.size() >= GpcLayout::kMaxRegions) {
    return std::nullopt;
  }
  constexpr int kSizes = 4;
  const size_t added = layout.regions.size();
  const glm::dvec2 asked(wanted.center);
  GpcRegion region = wanted;
  region.zoom = unfolded(layout, static_cast<double>(wanted.zoom), wanted.outer());
  for (int i = 0; i < kSizes; ++i, region.extent /= 2.0f) {
    if (const auto center = nearestCenter(layout, added, outerHalfOf(region), asked, size)) {
      region.center = glm::vec2(*center);
      const LensBox inner = lensInnerBox(region);
      if (glm::clamp(asked, inner.lower, inner.upper) == asked) {
        layout.regions.push_back(region);
        return added;
      }
    }
  }
  return std::nullopt;
}

void removeLens(GpcLayout& layout, size_t lens) {
  OC_CHECK(lens < layout.regions.size(), "an index is that of a lens");
  layout.regions.erase(layout.regions.begin() + static_cast<std::ptrdiff_t>(lens));
}

}  // namespace ocelli
