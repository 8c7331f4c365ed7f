// Where a bend of a curved ray camera is, and which blocks of a mesh it may show.
#pragma once

#include "oc_core/camera/curved_ray_camera.h"
#include "oc_core/render/straight_segment.h"

namespace ocelli {

/// The control points of the arc of a ray.
struct BendCorners {
  glm::dvec3 t{0};
  glm::dvec3 s{0};
  glm::dvec3 q{0};
};
BendCorners cornersOf(const CurvedRayCamera& camera, size_t bend, const glm::dvec2& pixel);

class BendBounds {
 public:
  BendBounds(const CurvedRayCamera& camera, size_t bend);

  /// Pixels from the world before and after the bend; weights are alike in its middle plane.
  const glm::dmat4& before() const { return before_; }
  const glm::dmat4& after() const { return after_; }
  /// Between its first and its last plane.
  const HalfSpaces& slab() const { return slab_; }
  /// Around all of its rays.
  const HalfSpaces& sides() const { return sides_; }
  /// Both together: what the bend may show lies within.
  HalfSpaces spaces() const;
  /// Around those of the pixels of a rectangle.
  HalfSpaces sidesOf(const CurvedRayCamera& camera, const PixelBounds& rect) const;
  /// A quarter of a pixel's footprint where it is smallest, world units.
  double shortestEdge() const { return shortestEdge_; }
  /// The least share of the bend (BendImage::share()) that rays have passed before they meet a box; a little less, for
  /// rounding.
  float leastShare(const Box& box) const;

 private:
  size_t bend_;
  glm::dmat4 before_;
  glm::dmat4 after_;
  HalfSpaces slab_;
  HalfSpaces sides_;
  double shortestEdge_ = 0;
};

}  // namespace ocelli
