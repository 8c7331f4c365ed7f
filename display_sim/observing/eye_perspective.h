// The perspective of an eye that looks at the display's centre.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "display_sim/observing/observer.h"

namespace ocelli {

/// What is nearer to the eye's plane than this has no image, in display radii.
inline constexpr double kNearestToEye = 1e-4;

/// (right, down, forward) coordinates from the eye and pixels from those.
class EyePerspective {
 public:
  explicit EyePerspective(const ObserverOptions& options)
      : eye_(options.eye), centerU_(options.width / 2.0), centerV_(options.height / 2.0) {
    distance = glm::length(eye_);
    forward_ = -eye_ / distance;
    // Straight from above or below there is no "up" on the y axis: what is farther from the default eye is up then.
    const glm::dvec3 up = std::abs(forward_.y) > 0.99999 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    right_ = glm::normalize(glm::cross(forward_, up));
    down_ = glm::cross(forward_, right_);
    const double halfFov =
        options.fovVerticalDegrees > 0 ? radiansFromDegrees(options.fovVerticalDegrees) / 2 : std::asin(1 / distance);
    pixelsPerTangent = options.height / 2.0 / std::tan(halfFov);
  }

  glm::dvec3 direction(const glm::dvec3& d) const {
    return {glm::dot(d, right_), glm::dot(d, down_), glm::dot(d, forward_)};
  }
  glm::dvec3 point(const glm::dvec3& p) const { return direction(p - eye_); }
  /// `p` is in eye coordinates with positive z.
  glm::dvec2 pixel(const glm::dvec3& p) const {
    return {centerU_ + pixelsPerTangent * p.x / p.z, centerV_ + pixelsPerTangent * p.y / p.z};
  }
  /// From the eye through a pixel, in the display's coordinates; it comes to distance 1 along the view direction.
  glm::dvec3 ray(double u, double v) const {
    return forward_ + right_ * ((u - centerU_) / pixelsPerTangent) + down_ * ((v - centerV_) / pixelsPerTangent);
  }

  const glm::dvec3& right() const { return right_; }

  double distance = 0;          ///< of the display's centre
  double pixelsPerTangent = 0;  ///< focal length in pixels

 private:
  glm::dvec3 eye_;
  double centerU_;
  double centerV_;
  glm::dvec3 forward_{0};
  glm::dvec3 right_{0};
  glm::dvec3 down_{0};
};

}  // namespace ocelli
