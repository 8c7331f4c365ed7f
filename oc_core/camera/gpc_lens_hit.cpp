#include "oc_core/camera/gpc_lens_hit.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr std::array kLensCorners{LensCorner::kTopLeft, LensCorner::kTopRight, LensCorner::kBottomLeft,
                                  LensCorner::kBottomRight};

/// How far `p` lies outside of a box, pixels, along the axis where that is most; negative inside.
double distanceOutside(const LensBox& box, const glm::dvec2& p, const glm::dvec2& size) {
  const glm::dvec2 outside = glm::max(box.lower - p, p - box.upper) * size;
  return std::max(outside.x, outside.y);
}

std::optional<LensCorner> cornerAt(const GpcRegion& lens, const glm::dvec2& at, double reach, const glm::dvec2& size) {
  constexpr double kMaxShare = 1.0 / 3;
  const bool isInside = distanceOutside(lensInnerBox(lens), at, size) < 0;
  const glm::dvec2 reached =
      isInside ? glm::min(glm::dvec2(reach), glm::dvec2(lens.extent) * size * kMaxShare) : glm::dvec2(reach);
  for (const LensCorner corner : kLensCorners) {
    const glm::dvec2 off = glm::abs(at - cornerOf(lens, corner)) * size;
    if (off.x <= reached.x && off.y <= reached.y) {
      return corner;
    }
  }
  return std::nullopt;
}

/// Where the outer edge is taken hold of: as `outer` would be there.
double outerAt(const GpcRegion& lens, const glm::dvec2& at) {
  const glm::dvec2 halves = glm::abs(at - glm::dvec2(lens.center)) / (glm::dvec2(lens.extent) / 2.0);
  return std::max(halves.x, halves.y);
}

}  // namespace

std::optional<LensHit> lensHitAt(const GpcLayout& layout, const glm::dvec2& at, double reach, const glm::dvec2& size) {
  for (size_t i = 0; i < layout.regions.size(); ++i) {
    if (const auto corner = cornerAt(layout.regions[i], at, reach, size)) {
      return LensHit{i, LensPart::kCorner, *corner};
    }
  }
  std::optional<LensHit> edge;
  for (size_t i = 0; i < layout.regions.size(); ++i) {
    const double outside = distanceOutside(lensBox(layout.regions[i]), at, size);
    const bool isInRegion = distanceOutside(lensInnerBox(layout.regions[i]), at, size) <= 0;
    if (!isInRegion && std::abs(outside) <= reach) {
      if (outside <= 0) {  // of two that touch, the one that holds the place
        return LensHit{i, LensPart::kOuterEdge};
      }
      edge = edge.value_or(LensHit{i, LensPart::kOuterEdge});
    } else if (outside < 0) {
      return LensHit{i, LensPart::kInside};
    }
  }
  return edge;
}

LensDrag::LensDrag(const GpcLayout& layout, const LensHit& hit, const glm::dvec2& at, const glm::dvec2& size)
    : start_(layout), hit_(hit), grabbed_(0), size_(size) {
  OC_CHECK(hit.lens < layout.regions.size(), "what is dragged is a lens");
  const GpcRegion& lens = layout.regions[hit.lens];
  switch (hit.part) {
    case LensPart::kInside:
      grabbed_ = glm::dvec2(lens.center) - at;
      return;
    case LensPart::kCorner:
      grabbed_ = cornerOf(lens, hit.corner) - at;
      return;
    case LensPart::kOuterEdge:
      grabbed_ = glm::dvec2(lens.outer() - outerAt(lens, at));
      return;
  }
}

GpcLayout LensDrag::layoutAt(const glm::dvec2& at) const {
  GpcLayout layout = start_;
  switch (hit_.part) {
    case LensPart::kInside:
      moveLens(layout, hit_.lens, at + grabbed_, size_);
      break;
    case LensPart::kCorner:
      dragLensCorner(layout, hit_.lens, hit_.corner, at + grabbed_, size_);
      break;
    case LensPart::kOuterEdge:
      widenLens(layout, hit_.lens, outerAt(layout.regions[hit_.lens], at) + grabbed_.x - 1);
      break;
  }
  return layout;
}

}  // namespace ocelli
