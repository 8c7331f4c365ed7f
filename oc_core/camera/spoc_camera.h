// The single pole occlusion camera (SPOC, section 3.1): a planar pinhole camera whose rays are pulled towards a pole, a
// point of the image and so a line of space, and thereby see around the object that stands on it.
//
// Projection (Equation 3.1) pushes the pinhole's image point away from the pole by d(z), which is linear in 1/z: from
// d_n at z_n to d_f at z_f. Nearer than z_n nothing is displaced; beyond z_f the displacement stays at d_f. (The text
// allows that, or to go on growing.) Unprojection (Equation 3.2) and rays are closed forms as well. A ray ends where it
// reaches the pole, and behind it nothing projects nearer to the pole than d(z).
//
// With d_n > 0 the projection jumps at z_n, and a ray steps aside there.
#pragma once

#include <span>

#include "oc_core/camera/distorted_pinhole.h"

namespace ocelli {

/// The six-tuple of the text; pixels and depths along the view direction.
struct SpocDistortion {
  glm::vec2 pole{0};     ///< (u_0, v_0)
  float zNear = 0;       ///< z_n
  float zFar = 0;        ///< z_f
  float nearPixels = 0;  ///< d_n
  float farPixels = 0;   ///< d_f
};

struct SpocOptions {
  /// d_f, as a share of the image height: how much of what is hidden comes out.
  float farDisplacementPerHeight = 0.1f;
  /// Puts z_n onto the object where the pole meets it, so that the object covers the hole around the pole (3.1.2).
  /// Otherwise z_n lies at its nearest point.
  bool maskPole = true;
};

class SpocCamera {
 public:
  /// Throws InputError where a number is not finite, not 0 < z_n < z_f, not 0 <= d_n <= d_f, or where d_f is longer
  /// than 10 image diagonals.
  SpocCamera(const PinholeCamera& reference, const SpocDistortion& distortion);

  /// The pole goes through the centroid of the images of `object`, z_f lies at the farthest point of `scene` in view.
  /// Both are world points; `scene` has those of `object` in it. Throws InputError where no point of the object is in
  /// view, or all of the scene is as far away as its front.
  static SpocCamera aroundObject(const PinholeCamera& reference, std::span<const glm::vec3> object,
                                 std::span<const glm::vec3> scene, const SpocOptions& options = {});

  int width() const { return reference_.width(); }
  int height() const { return reference_.height(); }
  const PinholeCamera& reference() const { return reference_; }
  const SpocDistortion& distortion() const { return distortion_; }
  float longestDisplacement() const { return distortion_.farPixels; }

  /// d(z) of Equation 3.1, pixels.
  float displacementAt(float z) const {
    if (z < distortion_.zNear) {
      return 0;
    }
    const float ramp = std::min((inverseNear_ - 1 / z) * perInverseZ_, 1.0f);
    return distortion_.nearPixels + (distortion_.farPixels - distortion_.nearPixels) * ramp;
  }

  /// A point on the pole itself, whose image is a circle, goes to its right: so its triangles are torn there.
  ImagePoint distort(const ImagePoint& q) const {
    const glm::vec2 fromPole = glm::vec2(q.u, q.v) - distortion_.pole;
    const float distance = glm::length(fromPole);
    const glm::vec2 direction = distance > 0 ? fromPole / distance : glm::vec2(1, 0);
    const glm::vec2 displacement = direction * displacementAt(q.t);
    return {q.u + displacement.x, q.v + displacement.y, q.t};
  }
  ImageBox displacementOver(const ImageBox& undistorted, float minInverseZ, float greatestInverseZ) const;

  /// Nothing for a displaced point on the pole.
  std::optional<ImagePoint> project(const glm::vec3& worldPoint) const;
  std::optional<glm::vec3> unproject(const ImagePoint& q) const;
  RayPath rayPath(const glm::vec2& pixel) const;

 private:
  std::optional<ImagePoint> undistort(const ImagePoint& q) const;

  PinholeCamera reference_;
  SpocDistortion distortion_;
  float inverseNear_;
  float perInverseZ_;  ///< 1 / (1/z_n - 1/z_f)
};

static_assert(DistortedPinhole<SpocCamera>);

}  // namespace ocelli
