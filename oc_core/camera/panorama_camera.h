// The panorama: straight rays in all directions from one eye, 360 by 180 degrees, as an equirectangular image.
//
// Columns are longitudes, from -180 degrees at the left border to 180 at the right one; the view direction is in the
// middle, and what lies to the right of it has positive longitudes. Rows are latitudes, from 90 degrees (the view's up)
// at the top to -90. t is the length of the ray. The field of view and the shift of the view say nothing here.
#pragma once

#include "oc_core/camera/camera.h"
#include "oc_core/camera/pinhole_camera.h"

namespace ocelli {

class PanoramaCamera {
 public:
  /// Eye, axes, zNear, zFar and the size are those of `reference`.
  explicit PanoramaCamera(const PinholeCamera& reference) : reference_(reference) {}

  int width() const { return reference_.width(); }
  int height() const { return reference_.height(); }
  const View& view() const { return reference_.view(); }
  /// The last column is next to the first.
  static constexpr bool kWrapsAround = true;

  /// Nothing for a point nearer than zNear or farther than zFar.
  std::optional<ImagePoint> project(const glm::vec3& worldPoint) const;
  std::optional<glm::vec3> unproject(const ImagePoint& q) const;
  RayPath rayPath(const glm::vec2& pixel) const;

 private:
  PinholeCamera reference_;
};

static_assert(Camera<PanoramaCamera>);

}  // namespace ocelli
