// The equidistant fisheye: the distance of a pixel from the middle of the image is proportional to the angle between
// its ray and the view direction. All rays meet at the eye; the image is a disc.
//
// t is the length of the ray from its first point, which lies zNear away from the eye.
#pragma once

#include "oc_core/camera/pinhole_camera.h"

class FisheyeCamera {
 public:
  /// Eye, axes, zNear, zFar and the size are those of `reference`. The disc is as wide as the image's shorter side. The
  /// field of view is that of the whole disc, less than 360 degrees.
  explicit FisheyeCamera(const ocelli::PinholeCamera& reference, double fieldOfViewDegrees = 180);

  // What the concept ocelli::Camera asks for.
  int width() const { return reference_.width(); }
  int height() const { return reference_.height(); }
  std::optional<ocelli::ImagePoint> project(const glm::vec3& worldPoint) const;
  std::optional<glm::vec3> unproject(const ocelli::ImagePoint& imagePoint) const;
  ocelli::RayPath rayPath(const glm::vec2& pixel) const;

 private:
  /// A unit vector in camera coordinates (right, down, forward); nothing outside of the disc.
  std::optional<glm::dvec3> directionOf(double u, double v) const;
  glm::vec3 pointAt(const glm::dvec3& direction, double distance) const;

  ocelli::PinholeCamera reference_;
  glm::dvec2 centerPixels_;
  double maxAngleRadians_;
  double pixelsPerRadian_;
};

static_assert(ocelli::Camera<FisheyeCamera>);
