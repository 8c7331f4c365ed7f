// Where there is room among rectangles: the free point that is nearest to a wanted one. What moves or sizes lenses of a
// general pinhole camera (gpc_lens_edit.h) asks this, with coordinates that are places or extents.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>

namespace ocelli {

/// A rectangle of the plane, which may be infinite.
struct LensBox {
  glm::dvec2 lower{0};
  glm::dvec2 upper{1};
};

/// Overlaps up to this are none: places are rounded to single precision. Half of what validate() of gpc_layout.h lets
/// pass.
inline constexpr double kLensTouch = 5e-7;

/// Of the points of `room` that lie within none of `taken`, whose borders are free, the one nearest to `wanted`;
/// distances are measured after each axis is multiplied by `scale`. Exact, and of points as near always the same.
/// Nothing where all of `room` is taken.
///
/// The nearest free point is the wanted one, or lies on borders: it has one coordinate of the wanted one, or of a
/// border, along each axis. These are all tried, nearest first.
std::optional<glm::dvec2> nearestFreePoint(const glm::dvec2& wanted, const LensBox& room,
                                           std::span<const LensBox> taken, const glm::dvec2& scale);

}  // namespace ocelli
