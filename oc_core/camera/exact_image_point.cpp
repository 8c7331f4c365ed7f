#include "oc_core/camera/exact_image_point.h"

#include <cmath>

namespace ocelli {

glm::dmat4 pixelFromWorld(const PinholeCamera& camera) {
  const glm::dvec3 eye(camera.eye());
  const auto row = [&](const glm::dvec3& axis) { return glm::dvec4(axis, -glm::dot(axis, eye)); };
  const glm::dvec4 z = row(glm::dvec3(camera.forward()));
  const auto focal = static_cast<double>(camera.focalPixels());
  const glm::dvec2 center(camera.centerPixels());
  const glm::dvec4 u = row(glm::dvec3(camera.right())) * focal + z * center.x;
  const glm::dvec4 v = row(glm::dvec3(camera.down())) * focal + z * center.y;
  return glm::transpose(glm::dmat4(u, v, glm::dvec4(0), z));
}

std::optional<ImagePoint> inSinglePrecision(const std::optional<ExactImagePoint>& q) {
  if (!q) {
    return std::nullopt;
  }
  const ImagePoint image{static_cast<float>(q->u), static_cast<float>(q->v), static_cast<float>(q->t)};
  return std::isfinite(image.u) && std::isfinite(image.v) ? std::optional(image) : std::nullopt;
}

}  // namespace ocelli
