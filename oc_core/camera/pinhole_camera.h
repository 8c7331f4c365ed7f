// The planar pinhole camera (PPC, section 1.2): all rays are straight and meet at the eye.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "oc_core/camera/camera.h"
#include "oc_core/camera/view.h"

namespace ocelli {

class PinholeCamera {
 public:
  static constexpr int kMaxPixelsASide = 32768;
  static constexpr int64_t kMaxPixels = int64_t{1} << 26;  ///< several gigabytes while such an image is made

  /// Throws InputError where the view is degenerate or the size exceeds these limits or is not positive.
  PinholeCamera(const View& view, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  const View& view() const { return view_; }
  const glm::vec3& eye() const { return view_.eye; }
  /// Focal length in pixels, the same along u and v: a surface at depth z has a pixel footprint of z / focalPixels().
  float focalPixels() const { return focal_; }
  /// Where the view direction meets the image, pixels: its middle, unless the view is sheared.
  glm::vec2 centerPixels() const { return {centerU_, centerV_}; }
  /// The axes of camera coordinates: unit vectors in the world.
  const glm::vec3& right() const { return right_; }
  const glm::vec3& down() const { return down_; }
  const glm::vec3& forward() const { return forward_; }

  /// (right, down, forward) coordinates of a world point relative to the eye; `.z` is the image z.
  glm::vec3 cameraFromWorld(const glm::vec3& worldPoint) const {
    const glm::vec3 p = worldPoint - view_.eye;
    return {glm::dot(p, right_), glm::dot(p, down_), glm::dot(p, forward_)};
  }
  glm::vec3 worldFromCamera(const glm::vec3& p) const {
    return view_.eye + right_ * p.x + down_ * p.y + forward_ * p.z;
  }
  ImagePoint imageFromCamera(const glm::vec3& p) const {
    return {centerU_ + focal_ * p.x / p.z, centerV_ + focal_ * p.y / p.z, p.z};
  }
  glm::vec3 cameraFromImage(const ImagePoint& q) const {
    return {(q.u - centerU_) / focal_ * q.t, (q.v - centerV_) / focal_ * q.t, q.t};
  }

  /// Nothing for a point nearer than zNear or farther than zFar along the view direction, or so far out that its image
  /// coordinates are not finite. A point outside of the image borders still has its image point.
  std::optional<ImagePoint> project(const glm::vec3& worldPoint) const {
    return projectCamera(cameraFromWorld(worldPoint));
  }
  /// The same for a point in camera coordinates.
  std::optional<ImagePoint> projectCamera(const glm::vec3& p) const {
    if (!(p.z >= view_.zNear && p.z <= view_.zFar)) {
      return std::nullopt;
    }
    const ImagePoint q = imageFromCamera(p);
    return std::isfinite(q.u) && std::isfinite(q.v) ? std::optional(q) : std::nullopt;
  }
  std::optional<glm::vec3> unproject(const ImagePoint& q) const {
    if (!(q.t >= view_.zNear && q.t <= view_.zFar) || !std::isfinite(q.u) || !std::isfinite(q.v)) {
      return std::nullopt;
    }
    return worldFromCamera(cameraFromImage(q));
  }
  RayPath rayPath(const glm::vec2& pixel) const;

  bool operator==(const PinholeCamera&) const = default;

 private:
  View view_;
  int width_;
  int height_;
  float focal_;
  float centerU_;
  float centerV_;
  glm::vec3 right_;
  glm::vec3 down_;
  glm::vec3 forward_;
};

static_assert(Camera<PinholeCamera>);

}  // namespace ocelli
