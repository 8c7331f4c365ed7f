// Reference images that rays can hit (sections 3.5.2.2 and 4.3.4.2): any camera's, also unions and layers. What stands
// behind RayTarget for a scene that has been sampled.
//
// DEVIATION: the text clips the ray to the image's bounds, projects pieces of it, and walks their images with coarse
// and fine steps. That may pass thin things, and needs the projection of the camera. Here the ray meets the surfaces
// between samples exactly, through a pyramid of their bounds (sample_pyramid.h); stepped_image.h is the text's way.
#pragma once

#include <memory>
#include <optional>

#include "oc_core/depth_rays/sample_cells.h"
#include "oc_core/depth_rays/sample_pyramid.h"
#include "oc_core/render/ray_target.h"

namespace ocelli {

class DepthImageTarget final : public RayTarget {
 public:
  /// Images without samples, and no image at all, are met by no ray.
  explicit DepthImageTarget(const ReferenceImages& images);

  /// The first surface between samples that the ray meets, from either side; its colour is interpolated between them.
  /// The element is the triangle: cells().placeOf(). Nothing for rays whose coordinates are not finite or as large as
  /// 1e18, and for pieces of rays shorter than StraightRay::kMinStep.
  std::optional<Hit> hit(const RayPath& ray) const override;
  /// The same; `cost` grows by what it took.
  std::optional<Hit> hit(const RayPath& ray, RayCost& cost) const;
  /// The same hit, found by testing every triangle: what tests compare with.
  std::optional<Hit> hitSlowly(const RayPath& ray) const;

  Box bounds() const override { return pyramid_.bounds(); }
  const SampleCells& cells() const { return *cells_; }
  const SamplePyramid& pyramid() const { return pyramid_; }
  /// The most steps that one straight piece of a ray can take.
  size_t maxSteps() const { return pyramid_.maxSteps(); }

 private:
  std::unique_ptr<SampleCells> cells_;  ///< stays where it is
  SamplePyramid pyramid_;
};

}  // namespace ocelli
