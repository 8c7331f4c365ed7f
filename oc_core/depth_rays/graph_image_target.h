// The image of a graph camera as a RayTarget that is walked frustum by frustum (section 4.3.4.2, graph_depth_image.h).
// Beside it stands depth_image_target.h, whose pyramid takes the samples of the same image.
#pragma once

#include <cstdint>

#include "oc_core/depth_rays/graph_depth_image.h"
#include "oc_core/depth_rays/ray_cost.h"
#include "oc_core/image/image.h"
#include "oc_core/render/ray_target.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

class GraphImageTarget final : public RayTarget {
 public:
  /// `fragments` is the camera's image of the mesh; the frusta are disjoint.
  GraphImageTarget(const GraphCamera& camera, const FragmentImage& fragments, const Mesh& mesh,
                   const GraphDepthImage::Options& options);

  /// The first surface of the image that the ray meets; the element is the number of its pixel, row by row. Of a ray of
  /// several straight pieces each is walked.
  std::optional<Hit> hit(const RayPath& ray) const override;
  /// The same; `cost.cells` grows by the pixels and tiles that were looked at.
  std::optional<Hit> hit(const RayPath& ray, RayCost& cost) const;
  /// The same without tiles, pixel by pixel: what tests compare with.
  std::optional<Hit> hitPixelByPixel(const RayPath& ray, RayCost& cost) const;

  Box bounds() const override { return bounds_; }
  size_t sampleCount() const { return samples_; }

 private:
  std::optional<Hit> firstHit(const RayPath& ray, const GraphDepthImage::Options& options, RayCost& cost) const;

  /// The pixel that shows what is met there: at a rim the nearest one around that shows something.
  glm::ivec2 shownPixel(const glm::dvec2& place) const;

  GraphDepthImage image_;
  GraphDepthImage::Options options_;
  Image<glm::vec3> colors_;
  Image<uint8_t> held_;
  Box bounds_;
  size_t samples_ = 0;
};

/// How thick surfaces are taken to be in a scene of that size: a 600th of its diagonal, 5 cm in a maze of 20 m.
double graphThickness(const Box& bounds);

}  // namespace ocelli
