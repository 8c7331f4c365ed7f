// The general pinhole camera (GPC, chapter 5): all rays are straight and meet at the eye, as a planar pinhole's, but
// the samples lie where detail is wanted. Regions of the image show more of it, and a transition around each makes up
// for it with fewer samples (gpc_map.h). Nothing is hidden that the pinhole sees, and nothing is seen that it does not.
//
// It displaces the image of its reference, by the same at every depth; t is z.
#pragma once

#include <memory>

#include "oc_core/camera/gpc_map.h"

namespace ocelli {

class GpcCamera {
 public:
  /// Eye, axes, field of view, zNear, zFar and the size are those of `reference`. Throws InputError for regions that
  /// are not valid: validate() of gpc_layout.h.
  GpcCamera(const PinholeCamera& reference, const GpcLayout& layout);

  int width() const { return reference_.width(); }
  int height() const { return reference_.height(); }
  const PinholeCamera& reference() const { return reference_; }
  const GpcMap& map() const { return *map_; }
  float longestDisplacement() const { return longestDisplacement_; }
  /// The greatest rate at which it samples anywhere.
  float greatestRate() const { return greatestRate_; }

  ImagePoint distort(const ImagePoint& q) const {
    const glm::dvec2 image = map_->imageFromPinhole(glm::dvec2(q.u, q.v));
    return {static_cast<float>(image.x), static_cast<float>(image.y), q.t};
  }
  ImageBox displacementOver(const ImageBox& undistorted, float minInverseZ, float greatestInverseZ) const;
  bool displacesWithin(const ImageBox& undistorted) const;

  std::optional<ImagePoint> project(const glm::vec3& worldPoint) const;
  std::optional<glm::vec3> unproject(const ImagePoint& q) const;
  RayPath rayPath(const glm::vec2& pixel) const;

 private:
  PinholeCamera reference_;
  std::shared_ptr<const GpcMap> map_;
  float longestDisplacement_ = 0;
  float greatestRate_ = 1;
};

static_assert(DistortedPinhole<GpcCamera>);

}  // namespace ocelli
