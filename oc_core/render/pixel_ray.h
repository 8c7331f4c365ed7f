// The straight pieces of the ray of one pixel, as cameras of the graph camera family bend it, and z along it: its
// length times the cosine between its first piece and the view direction (graph_camera.h).
#pragma once

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/camera/plane.h"

namespace ocelli {

/// A pinhole, ready for many rays.
class PixelRays {
 public:
  explicit PixelRays(const PinholeCamera& root)
      : eye_(root.eye()),
        right_(glm::dvec3(root.right()) / static_cast<double>(root.focalPixels())),
        down_(glm::dvec3(root.down()) / static_cast<double>(root.focalPixels())),
        corner_(glm::dvec3(root.forward()) - right_ * static_cast<double>(root.centerPixels().x) -
                down_ * static_cast<double>(root.centerPixels().y)) {}

  const glm::dvec3& eye() const { return eye_; }
  /// z grows by 1 along it.
  glm::dvec3 direction(const glm::dvec2& pixel) const { return corner_ + right_ * pixel.x + down_ * pixel.y; }

 private:
  glm::dvec3 eye_;
  glm::dvec3 right_;
  glm::dvec3 down_;
  glm::dvec3 corner_;
};

class PixelRay {
 public:
  PixelRay(const PixelRays& rays, const glm::dvec2& pixel)
      : from_(rays.eye()), direction_(rays.direction(pixel)), perLength_(1 / glm::length(direction_)) {}

  /// From where it crosses a plane it runs on, away from a viewpoint.
  void bend(const Plane& plane, const glm::dvec3& viewpoint) {
    const glm::dvec3 crossing = cross(plane);
    z_ = zOf(crossing);
    from_ = crossing;
    direction_ = crossing - viewpoint;
  }
  glm::dvec3 cross(const Plane& plane) const {
    return from_ - direction_ * (plane.height(from_) / glm::dot(plane.normal, direction_));
  }
  /// z of a point of its last piece.
  double zOf(const glm::dvec3& point) const { return z_ + glm::distance(from_, point) * perLength_; }
  /// What z grows by for a unit of length.
  double perLength() const { return perLength_; }
  /// Not normalised.
  const glm::dvec3& direction() const { return direction_; }

 private:
  glm::dvec3 from_;
  glm::dvec3 direction_;
  double perLength_;
  double z_ = 0;
};

}  // namespace ocelli
