#include "fisheye_camera.h"

#include <algorithm>
#include <cmath>

using ocelli::ImagePoint;
using ocelli::RayPath;

FisheyeCamera::FisheyeCamera(const ocelli::PinholeCamera& reference, double fieldOfViewDegrees)
    : reference_(reference),
      centerPixels_(reference.width() / 2.0, reference.height() / 2.0),
      maxAngleRadians_(ocelli::radiansFromDegrees(fieldOfViewDegrees) / 2),
      pixelsPerRadian_(std::min(centerPixels_.x, centerPixels_.y) / maxAngleRadians_) {}

std::optional<ImagePoint> FisheyeCamera::project(const glm::vec3& worldPoint) const {
  const glm::dvec3 p(reference_.cameraFromWorld(worldPoint));
  const double distance = glm::length(p);
  const double besideTheAxis = std::hypot(p.x, p.y);
  const double angle = std::atan2(besideTheAxis, p.z);
  const ocelli::View& view = reference_.view();
  if (!(distance >= double(view.zNear) && distance <= double(view.zFar) && angle <= maxAngleRadians_)) {
    return std::nullopt;
  }
  // Straight ahead every direction in the image is as good.
  const glm::dvec2 outwards = besideTheAxis > 0 ? glm::dvec2(p.x, p.y) / besideTheAxis : glm::dvec2(0);
  const glm::dvec2 pixel = centerPixels_ + outwards * (angle * pixelsPerRadian_);
  return ImagePoint{float(pixel.x), float(pixel.y), float(distance - double(view.zNear))};
}

std::optional<glm::vec3> FisheyeCamera::unproject(const ImagePoint& imagePoint) const {
  const auto [u, v, t] = imagePoint;
  const ocelli::View& view = reference_.view();
  const std::optional<glm::dvec3> direction = directionOf(u, v);
  if (!direction || !(t >= 0 && t <= view.zFar - view.zNear)) {
    return std::nullopt;
  }
  return pointAt(*direction, double(view.zNear) + double(t));
}

RayPath FisheyeCamera::rayPath(const glm::vec2& pixel) const {
  const std::optional<glm::dvec3> direction = directionOf(pixel.x, pixel.y);
  if (!direction) {
    return {};
  }
  return {pointAt(*direction, reference_.view().zNear), pointAt(*direction, reference_.view().zFar)};
}

std::optional<glm::dvec3> FisheyeCamera::directionOf(double u, double v) const {
  const glm::dvec2 offset = glm::dvec2(u, v) - centerPixels_;
  const double radius = glm::length(offset);
  const double angle = radius / pixelsPerRadian_;
  if (!(angle <= maxAngleRadians_)) {
    return std::nullopt;
  }
  const glm::dvec2 outwards = radius > 0 ? offset / radius : glm::dvec2(0);
  return glm::dvec3(outwards * std::sin(angle), std::cos(angle));
}

glm::vec3 FisheyeCamera::pointAt(const glm::dvec3& direction, double distance) const {
  return reference_.worldFromCamera(glm::vec3(direction * distance));
}
