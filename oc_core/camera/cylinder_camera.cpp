#include "oc_core/camera/cylinder_camera.h"

#include "oc_core/camera/straight_ray.h"

namespace ocelli {

std::optional<ImagePoint> CylinderCamera::project(const glm::vec3& worldPoint) const {
  const glm::dvec3 p(reference_.cameraFromWorld(worldPoint));
  const double length = glm::length(p);
  const double across = std::hypot(p.x, p.z);
  const double v = height() / 2.0 + static_cast<double>(reference_.focalPixels()) * p.y / across;
  if (!isWithin(view(), length) || !std::isfinite(static_cast<float>(v))) {
    return std::nullopt;
  }
  const double longitude = std::atan2(p.x, p.z);
  return ImagePoint{static_cast<float>((0.5 + longitude / (2 * kPi)) * width()), static_cast<float>(v),
                    static_cast<float>(length)};
}

std::optional<glm::vec3> CylinderCamera::unproject(const ImagePoint& q) const {
  if (!isWithin(view(), static_cast<double>(q.t)) || !std::isfinite(q.u) || !std::isfinite(q.v)) {
    return std::nullopt;
  }
  const double longitude = (static_cast<double>(q.u) / width() - 0.5) * 2 * kPi;
  const glm::dvec3 along(std::sin(longitude),
                         (static_cast<double>(q.v) - height() / 2.0) / static_cast<double>(reference_.focalPixels()),
                         std::cos(longitude));
  return reference_.worldFromCamera(glm::vec3(along * (static_cast<double>(q.t) / glm::length(along))));
}

RayPath CylinderCamera::rayPath(const glm::vec2& pixel) const {
  return straightRay(*this, pixel, view());
}

}  // namespace ocelli
