// The depth discontinuity occlusion camera (DDOC, section 3.2): a planar pinhole camera whose rays are pushed out from
// behind the silhouettes of the scene, pixel by pixel, as a distortion map says.
//
// Projection (Equation 3.3) is closed: project with the pinhole, look the distortion up at the undistorted pixel,
// displace. The inverse is not: the map is sampled, so `unproject` and `rayPath` solve for the undistorted pixel depth
// by depth, in one or two steps from the slopes of the map's cells. Where the field folds (possible with the
// discontinuous map of the text, kept small by the smooth one), one of the solutions is returned, or none. A reference
// image therefore stores the displacement of each sample and unprojects exactly (3.2.3).
#pragma once

#include <cstdint>
#include <glm/common.hpp>
#include <memory>
#include <mutex>

#include "oc_core/camera/displacement_bounds.h"
#include "oc_core/camera/distorted_pinhole.h"
#include "oc_core/camera/distortion_map.h"

namespace ocelli {

class DdocCamera {
 public:
  /// `map` has one sample for each pixel of `reference`.
  DdocCamera(const PinholeCamera& reference, DistortionMap map);

  int width() const { return reference_.width(); }
  int height() const { return reference_.height(); }
  const PinholeCamera& reference() const { return reference_; }
  const DistortionMap& map() const { return map_; }
  float longestDisplacement() const { return longestDisplacement_; }
  /// False where no point with an undistorted image in the box is displaced, whatever its depth.
  bool displacesWithin(const ImageBox& undistorted) const;
  /// Map samples that displace, above and to the left of each corner of a pixel.
  const Image<uint32_t>& displacedBefore() const { return displacedBefore_; }
  ImageBox displacementOver(const ImageBox& undistorted, float minInverseZ, float greatestInverseZ) const {
    return bounds().over(undistorted).at(minInverseZ, greatestInverseZ);
  }

  ImagePoint distort(const ImagePoint& q) const {
    const glm::vec2 displacement = map_.at(q.u, q.v).at(1 / q.t);
    return {q.u + displacement.x, q.v + displacement.y, q.t};
  }

  std::optional<ImagePoint> project(const glm::vec3& worldPoint) const {
    const std::optional<ImagePoint> undistorted = reference_.project(worldPoint);
    return undistorted ? std::optional(distort(*undistorted)) : std::nullopt;
  }
  std::optional<glm::vec3> unproject(const ImagePoint& q) const;
  RayPath rayPath(const glm::vec2& pixel) const;

 private:
  /// Made when they are first needed: rasterisation takes none. Safe from several threads.
  struct LazyBounds {
    std::once_flag made;
    DisplacementBounds bounds;
  };
  const DisplacementBounds& bounds() const {
    std::call_once(bounds_->made, [&] { bounds_->bounds = DisplacementBounds(map_); });
    return bounds_->bounds;
  }
  /// The undistorted image point that is displaced to q, found from a guess: directly where the field is smooth, by
  /// a search where it is not.
  std::optional<ImagePoint> undistort(const ImagePoint& q, const glm::vec2& guess) const;
  std::optional<ImagePoint> undistortDirectly(const ImagePoint& q, const glm::vec2& guess) const;
  std::optional<ImagePoint> searchUndistorted(const ImagePoint& q, const glm::vec2& guess) const;

  PinholeCamera reference_;
  DistortionMap map_;
  float longestDisplacement_;
  std::shared_ptr<LazyBounds> bounds_;  ///< copies of the camera share them
  Image<uint32_t> displacedBefore_;
};

static_assert(DistortedPinhole<DdocCamera>);

inline bool DdocCamera::displacesWithin(const ImageBox& undistorted) const {
  // The map is looked up between pixel centres, and beyond the borders at the nearest one.
  const glm::vec2 last(static_cast<float>(width() - 1), static_cast<float>(height() - 1));
  const glm::ivec2 lower = glm::clamp(undistorted.lower - 0.5f, glm::vec2(0), last);
  const glm::ivec2 upper =
      glm::min(glm::ivec2(glm::clamp(undistorted.upper - 0.5f, glm::vec2(0), last)) + 2, glm::ivec2(width(), height()));
  return displacedBefore_(upper.x, upper.y) + displacedBefore_(lower.x, lower.y) !=
         displacedBefore_(lower.x, upper.y) + displacedBefore_(upper.x, lower.y);
}

}  // namespace ocelli
