// What a half plane through the ray of a pixel hides of the light at a point, as the horizon in it rises. For .cpp
// files.
//
// Angles g are from the direction towards the viewpoint. In a half plane at azimuth a around that direction a
// direction is dw = sin g dg da, and weighs l cos(g - gn) where the normal, projected into the plane, has length l and
// angle gn. The tangent plane is at gn + 90 degrees.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "oc_core/ambient/ambient_options.h"

namespace ocelli {

/// The surface at a point as its pixel's ray sees it.
struct HorizonPoint {
  glm::dvec3 position{0};
  glm::dvec3 normal{0};
  glm::dvec3 towards{0};  ///< the viewpoint; unit

  /// Of the tangent plane, in the half plane with the unit vector `side` across `towards`.
  double tangentAngle(const glm::dvec3& side) const {
    return std::atan2(glm::dot(normal, side), glm::dot(normal, towards)) + std::numbers::pi / 2;
  }
};

class HorizonSlice {
 public:
  /// `side` is a unit vector across `point.towards`.
  HorizonSlice(const HorizonPoint& point, const glm::dvec3& side, const AmbientOptions& options)
      : point_(point), options_(options), side_(side), horizon_(point.tangentAngle(side)), tangent_(horizon_) {
    normalAngle_ = horizon_ - std::numbers::pi / 2;
    length_ = std::hypot(glm::dot(point.normal, side), glm::dot(point.normal, point.towards));
  }

  /// A sample that lies in the half plane, or about so: its height over the tangent plane is that in its own plane. One
  /// that lies farther aside, as behind a bend of rays or where two frusta meet, tells nothing of this half plane.
  void add(const glm::dvec3& sample) {
    const glm::dvec3 way = sample - point_.position;
    const double distance = glm::length(way);
    if (!(distance < options_.radius) || !(glm::dot(way, point_.normal) > kMinRise * distance)) {
      return;
    }
    const double ahead = glm::dot(way, point_.towards);
    const glm::dvec3 across = way - point_.towards * ahead;
    const double aside = glm::length(across);
    if (glm::dot(across, side_) < kMinCosine * aside) {
      return;
    }
    const double above =
        aside > 0 ? point_.tangentAngle(across / aside) - std::atan2(aside, ahead) : std::numbers::pi / 2;
    const double angle = std::max(tangent_ - above, 0.0);
    if (angle < horizon_) {
      hidden_ += options_.weight(distance) * (integral(horizon_) - integral(angle));
      horizon_ = angle;
    }
  }

  /// Of the light, times the number of radians that the half plane stands for.
  double hidden() const { return hidden_ * length_ / std::numbers::pi; }

 private:
  /// Samples of the surface itself rise by what rounding makes of them.
  static constexpr double kMinRise = 1e-3;
  /// Between the plane of a sample and this one: pixels next to the point lie up to 45 degrees beside a line.
  static constexpr double kMinCosine = 0.5;

  /// Of cos(g - gn) sin g.
  double integral(double g) const { return 0.5 * g * std::sin(normalAngle_) - 0.25 * std::cos(2 * g - normalAngle_); }

  const HorizonPoint& point_;
  const AmbientOptions& options_;
  glm::dvec3 side_;
  double horizon_;
  double tangent_;
  double normalAngle_ = 0;
  double length_ = 0;
  double hidden_ = 0;
};

}  // namespace ocelli
