#include "oc_core/explore_window/explore_tints.h"

#include <glm/common.hpp>

namespace ocelli {
namespace {

/// Of a border, at 96 dots an inch: a number fits into it.
constexpr float kMinTintWidth = 16;
constexpr float kMinTintHeight = 28;

}  // namespace

TintExtent extentOf(const WindowTint& tint) {
  TintExtent extent{tint.outline.front(), tint.outline.front()};
  for (const glm::vec2& point : tint.outline) {
    extent.lower = glm::min(extent.lower, point);
    extent.upper = glm::max(extent.upper, point);
  }
  return extent;
}

bool showsTint(const WindowTint& tint, float scale) {
  if (tint.color <= 0 || tint.outline.size() < 3) {
    return false;
  }
  const TintExtent extent = extentOf(tint);
  const glm::vec2 size = (extent.upper - extent.lower) * scale;
  return size.x >= kMinTintWidth && size.y >= kMinTintHeight;
}

}  // namespace ocelli
