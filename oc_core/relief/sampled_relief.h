// A relief object by reference images of any camera: rays meet the surfaces between samples, through a pyramid of their
// bounds (oc_core/depth_rays).
#pragma once

#include <vector>

#include "oc_core/depth_rays/sample_pyramid.h"
#include "oc_core/ocri/reference_image.h"
#include "oc_core/relief/relief_object.h"
#include "oc_core/relief/surface_labels.h"

namespace ocelli {

class SampledRelief final : public ReliefObject {
 public:
  /// The images are of labels.labelledMesh(). Images without samples are met by no ray.
  SampledRelief(const ReferenceImages& images, const SurfaceLabels& labels);

  std::optional<TriangleMeeting> meet(const StraightRay& ray, RayCost& cost) const override;
  std::optional<TriangleMeeting> meetSlowly(const StraightRay& ray) const override;
  void meetBlock(RayBlock& block, RayCost& cost) const override;
  ReliefSurface surfaceAt(const TriangleMeeting& meeting) const override;

  Box bounds() const override { return pyramid_.bounds(); }
  size_t texels() const override { return texels_; }
  size_t samples() const override { return samples_; }
  float texelSize() const override { return texelSize_; }
  const SampleCells& cells() const { return cells_; }

 private:
  float raySpacingAt(const RayBlock& block) const;

  SampleCells cells_;
  SamplePyramid pyramid_;
  std::vector<ReliefSurface> surfaceOfVertex_;
  size_t texels_ = 0;
  size_t samples_ = 0;
  float texelSize_ = 0;
};

}  // namespace ocelli
