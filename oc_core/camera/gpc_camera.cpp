#include "oc_core/camera/gpc_camera.h"

#include <cmath>

#include "oc_core/camera/straight_ray.h"

namespace ocelli {
namespace {

/// The outer rectangle of a zone, in both images.
ImageBox outerBox(const GpcZone& zone) {
  return {glm::vec2(zone.center() - zone.outerHalf()), glm::vec2(zone.center() + zone.outerHalf())};
}

ImageBox common(const ImageBox& a, const ImageBox& b) {
  return {glm::max(a.lower, b.lower), glm::min(a.upper, b.upper)};
}

bool isEmpty(const ImageBox& box) {
  return !(box.lower.x <= box.upper.x && box.lower.y <= box.upper.y);
}

}  // namespace

GpcCamera::GpcCamera(const PinholeCamera& reference, const GpcLayout& layout)
    : reference_(reference), map_(std::make_shared<const GpcMap>(layout, reference.width(), reference.height())) {
  for (const GpcZone& zone : map_->zones()) {
    const double longest = zone.profile().longestShift() * glm::length(zone.half());
    longestDisplacement_ = std::max(longestDisplacement_, static_cast<float>(longest) * 1.0001f);
    greatestRate_ = std::max(greatestRate_, static_cast<float>(zone.profile().greatestRate()));
  }
}

bool GpcCamera::displacesWithin(const ImageBox& undistorted) const {
  for (const GpcZone& zone : map_->zones()) {
    if (!isEmpty(common(undistorted, outerBox(zone)))) {
      return true;
    }
  }
  return false;
}

ImageBox GpcCamera::displacementOver(const ImageBox& undistorted, float, float) const {
  ImageBox displacement;
  for (const GpcZone& zone : map_->zones()) {
    const ImageBox part = common(undistorted, outerBox(zone));
    if (!isEmpty(part)) {
      const glm::vec2 center(zone.center());
      const glm::vec2 factors(zone.magnificationOver(part) - 1.0);
      const ImageBox of = scaled({part.lower - center, part.upper - center}, factors.x, factors.y);
      displacement = {glm::min(displacement.lower, of.lower), glm::max(displacement.upper, of.upper)};
    }
  }
  return displacement;
}

std::optional<ImagePoint> GpcCamera::project(const glm::vec3& worldPoint) const {
  const glm::dvec3 p = glm::dvec3(worldPoint) - glm::dvec3(reference_.eye());
  const double z = glm::dot(p, glm::dvec3(reference_.forward()));
  if (!isWithin(reference_.view(), z)) {
    return std::nullopt;
  }
  const glm::dvec2 across(glm::dot(p, glm::dvec3(reference_.right())), glm::dot(p, glm::dvec3(reference_.down())));
  const glm::dvec2 image = map_->imageFromPinhole(glm::dvec2(reference_.centerPixels()) +
                                                  across * (static_cast<double>(reference_.focalPixels()) / z));
  const ImagePoint q{static_cast<float>(image.x), static_cast<float>(image.y), static_cast<float>(z)};
  return std::isfinite(q.u) && std::isfinite(q.v) ? std::optional(q) : std::nullopt;
}

std::optional<glm::vec3> GpcCamera::unproject(const ImagePoint& q) const {
  if (!isWithin(reference_.view(), static_cast<double>(q.t)) || !std::isfinite(q.u) || !std::isfinite(q.v)) {
    return std::nullopt;
  }
  const glm::dvec2 pinhole = map_->pinholeFromImage(glm::dvec2(q.u, q.v));
  const auto z = static_cast<double>(q.t);
  const glm::dvec2 across =
      (pinhole - glm::dvec2(reference_.centerPixels())) * (z / static_cast<double>(reference_.focalPixels()));
  return glm::vec3(glm::dvec3(reference_.eye()) + glm::dvec3(reference_.right()) * across.x +
                   glm::dvec3(reference_.down()) * across.y + glm::dvec3(reference_.forward()) * z);
}

RayPath GpcCamera::rayPath(const glm::vec2& pixel) const {
  return straightRay(*this, pixel, reference_.view());
}

}  // namespace ocelli
