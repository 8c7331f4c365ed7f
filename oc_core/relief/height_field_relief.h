// Conventional relief texture mapping, to be compared with: an orthographic height field along the normal of the tile,
// or several layers of it ([124], [125] of the text), and a search along the ray by equal steps and then by halves, as
// graphics hardware does it (16 and 5 are today's usual numbers).
//
// A step may pass what is thinner; walls between neighbouring pixels of different height are drawn, whether the object
// has them or not ("rubber bands").
#pragma once

#include "oc_core/relief/orthographic_layers.h"
#include "oc_core/relief/relief_object.h"

namespace ocelli {

struct ReliefSearch {
  int linearSteps = 16;
  int halvings = 5;
};

class HeightFieldRelief final : public ReliefObject {
 public:
  /// With one layer all below a surface is solid. With more, what lies between the first and the second layer is, and
  /// so on in turn, as in a closed object.
  HeightFieldRelief(OrthographicLayers layers, const ReliefSearch& search);

  /// The number of a meeting is that of the layer, the weights are the place in the image, as shares of its sides.
  std::optional<TriangleMeeting> meet(const StraightRay& ray, RayCost& cost) const override;
  /// With 64 times as many steps and halves of 1e-7: no peer, but what the same image has when nothing is passed.
  std::optional<TriangleMeeting> meetSlowly(const StraightRay& ray) const override;
  ReliefSurface surfaceAt(const TriangleMeeting& meeting) const override;

  Box bounds() const override { return bounds_; }
  size_t texels() const override;
  size_t samples() const override { return samples_; }
  float texelSize() const override { return texelSize_; }

 private:
  /// What the images say of a point: which surface is the next one above it, and whether it is inside.
  struct Inside {
    bool inside = false;
    uint32_t layer = 0;
  };
  Inside insideAt(const glm::vec3& pixels) const;
  std::optional<TriangleMeeting> search(const StraightRay& ray, const ReliefSearch& how, RayCost& cost) const;

  OrthographicLayers layers_;
  ReliefSearch search_;
  Box bounds_;
  size_t samples_ = 0;
  float texelSize_ = 0;
};

}  // namespace ocelli
