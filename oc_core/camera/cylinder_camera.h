// The cylindrical panorama: straight rays from one eye, 360 degrees around its up direction.
//
// Columns are longitudes, from -180 degrees at the left border to 180 at the right one, with the view direction in the
// middle. Rows are those of a planar image: v = h/2 - f tan(latitude), with f from the vertical field of view, so that
// vertical lines are straight. z is the length of the ray. The view's shift says nothing here.
#pragma once

#include "oc_core/camera/camera.h"
#include "oc_core/camera/pinhole_camera.h"

namespace ocelli {

class CylinderCamera {
 public:
  /// Eye, axes, field of view, zNear, zFar and the size are those of `reference`.
  explicit CylinderCamera(const PinholeCamera& reference) : reference_(reference) {}

  int width() const { return reference_.width(); }
  int height() const { return reference_.height(); }
  const View& view() const { return reference_.view(); }
  /// The last column is next to the first.
  static constexpr bool kWrapsAround = true;

  /// Nothing for a point nearer than zNear or farther than zFar, or on the axis.
  std::optional<ImagePoint> project(const glm::vec3& worldPoint) const;
  std::optional<glm::vec3> unproject(const ImagePoint& q) const;
  RayPath rayPath(const glm::vec2& pixel) const;

 private:
  PinholeCamera reference_;
};

static_assert(Camera<CylinderCamera>);

}  // namespace ocelli
