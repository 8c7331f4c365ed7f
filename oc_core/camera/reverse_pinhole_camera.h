// The reverse planar pinhole camera (RPPC, section 3.1.1): its frustum shrinks with the distance, since all of its rays
// are straight and meet at a point behind the scene. So it sees sides of objects that hide behind their fronts. It is
// what the single pole occlusion camera grew out of, and a baseline for it.
//
// With x, y and z along the axes of a reference pinhole at the eye, u = u_c + f x / z' (z_m - z') / (z_m - z), and v
// alike: at depth z' its image is that of the reference, whose rays it crosses there; at z_m its rays meet. Seen from
// the reference it displaces image points along the line from the image centre, by a closed form both ways.
//
// The range of depths is that of the reference: zNear <= z <= zFar. It must be narrow, as the frustum at zNear is wider
// than the image, and that at zFar has to lie before the rays meet.
//
// DEVIATION: the text renders it as the opposite pinhole with the depth test reversed. Here it is one more displaced
// pinhole, so that every renderer works for it as it is, and z keeps its meaning.
#pragma once

#include <span>

#include "oc_core/camera/distorted_pinhole.h"

namespace ocelli {

class ReversePinholeCamera {
 public:
  /// The widest that the frustum may open before z', relative to that of the reference.
  static constexpr float kWidestOpening = 100;

  /// `sameImageDepth` is z', `meetingDepth` z_m. Throws InputError where not zNear <= z' <= zFar < z_m, or where the
  /// image at zNear would be smaller than 1 / kWidestOpening.
  ReversePinholeCamera(const PinholeCamera& reference, float sameImageDepth, float meetingDepth);

  /// Opposite to the eye, around the middle of the depths of those `points` that `reference` has an image of: z' is the
  /// middle, and z_m twice that. The range of depths becomes that of the points, a little wider. Throws InputError
  /// where no point is in view.
  static ReversePinholeCamera around(const PinholeCamera& reference, std::span<const glm::vec3> points);

  int width() const { return reference_.width(); }
  int height() const { return reference_.height(); }
  const PinholeCamera& reference() const { return reference_; }
  float sameImageDepth() const { return sameImageDepth_; }
  float meetingDepth() const { return meetingDepth_; }
  float longestDisplacement() const { return longestDisplacement_; }

  ImagePoint distort(const ImagePoint& q) const {
    const glm::vec2 center = reference_.centerPixels();
    const glm::vec2 image = center + (glm::vec2(q.u, q.v) - center) * magnificationAt(q.t);
    return {image.x, image.y, q.t};
  }
  ImageBox displacementOver(const ImageBox& undistorted, float minInverseZ, float greatestInverseZ) const;

  std::optional<ImagePoint> project(const glm::vec3& worldPoint) const;
  std::optional<glm::vec3> unproject(const ImagePoint& q) const;
  RayPath rayPath(const glm::vec2& pixel) const;

 private:
  /// Distance from the image centre, relative to that of the reference. It grows with z.
  float magnificationAt(float z) const {
    return z / sameImageDepth_ * (meetingDepth_ - sameImageDepth_) / (meetingDepth_ - z);
  }

  PinholeCamera reference_;
  float sameImageDepth_;
  float meetingDepth_;
  float longestDisplacement_ = 0;
};

static_assert(DistortedPinhole<ReversePinholeCamera>);

}  // namespace ocelli
