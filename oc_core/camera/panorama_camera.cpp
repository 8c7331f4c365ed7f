#include "oc_core/camera/panorama_camera.h"

#include "oc_core/camera/straight_ray.h"

namespace ocelli {

std::optional<ImagePoint> PanoramaCamera::project(const glm::vec3& worldPoint) const {
  const glm::dvec3 p(reference_.cameraFromWorld(worldPoint));
  const double length = glm::length(p);
  if (!isWithin(view(), length)) {
    return std::nullopt;
  }
  const double longitude = std::atan2(p.x, p.z);
  const double latitude = std::asin(std::clamp(-p.y / length, -1.0, 1.0));
  return ImagePoint{static_cast<float>((0.5 + longitude / (2 * kPi)) * width()),
                    static_cast<float>((0.5 - latitude / kPi) * height()), static_cast<float>(length)};
}

std::optional<glm::vec3> PanoramaCamera::unproject(const ImagePoint& q) const {
  if (!isWithin(view(), static_cast<double>(q.t)) || !std::isfinite(q.u) || !std::isfinite(q.v)) {
    return std::nullopt;
  }
  const double longitude = (static_cast<double>(q.u) / width() - 0.5) * 2 * kPi;
  const double latitude = (0.5 - static_cast<double>(q.v) / height()) * kPi;
  const glm::dvec3 direction(std::cos(latitude) * std::sin(longitude), -std::sin(latitude),
                             std::cos(latitude) * std::cos(longitude));
  return reference_.worldFromCamera(glm::vec3(direction * static_cast<double>(q.t)));
}

RayPath PanoramaCamera::rayPath(const glm::vec2& pixel) const {
  return straightRay(*this, pixel, view());
}

}  // namespace ocelli
