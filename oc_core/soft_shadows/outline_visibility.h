// The visibility of an area light by the outlines of what hides it: ours. Occluders are the surfaces of a reference
// image (section 3.5.3: an occlusion camera at the light holds what all points of the light see), or any mesh.
//
// Seen from a receiver, the number of surfaces before the light changes only where an edge with a triangle on one side,
// or with two that face the receiver differently, is projected onto the light. So
//   1. blocks of neighbouring receivers find the edges that can do so for any of them, in a hierarchy (edge_tree.h);
//   2. each receiver projects these alone onto the samples of the light (light_cover.h), which gives the number of
//      surfaces before each sample up to a number that all share;
//   3. one ray to a sample with the fewest tells that number: where it is free, the samples with as few are what the
//      receiver sees; where it is blocked, all are. Receivers with no edge before the light are decided by the ray
//      alone. A second ray to another of them must say the same, and one to a sample that more hide must be blocked:
//      where that is not so (a ray passed an edge closer than numbers are exact), each sample gets a ray.
// After S. Laine et al., Soft shadow volumes for ray tracing, SIGGRAPH 2005, who take the edges of the geometry.
//
// The error has two parts.
//   Of the light's samples: a sample stands for its cell, the n-th part of the light's width and height. A cell that no
//   edge crosses is right, so what is wrong is less than the area of the cells that outlines cross: at most 2n - 1 of
//   n^2 a straight edge. Where in its cell an edge passes is as good as random, so that k crossings, which each round
//   by 1/12 of a variance of a cell's area, leave sqrt(k / 12) / n^2: the first part of the estimate. Of the occluders'
//   samples: their rims are off by up to half a footprint, projected onto the light; times the length of the outlines
//   there, as all could be off to the same side: the second part. What the image does not hold at all is in neither.
#pragma once

#include "oc_core/render/blocked_rays.h"
#include "oc_core/soft_shadows/area_visibility.h"
#include "oc_core/soft_shadows/edge_tree.h"
#include "oc_core/soft_shadows/light_grid.h"

namespace ocelli {

struct OutlineOptions {
  int gridSide = 32;  ///< of the samples of the light: 8, 16, 24 or 32
  ReceiverLift lift = {};
  /// Of samples of the occluders, of their distance from the plane of the light; 0 for exact geometry.
  float footprintPerDistance = 0;
};

class OutlineVisibility final : public AreaVisibility {
 public:
  OutlineVisibility(const Mesh& occluders, const AreaLight& light, const OutlineOptions& options = {});

  LightVisibility of(std::span<const ShadowReceiver> receivers) const override;

  size_t edgeCount() const { return edges_.rims.size() + edges_.folds.size(); }
  const OccluderEdges& edges() const { return edges_; }

 private:
  LightFrame frame_;
  OutlineOptions options_;
  LightGrid grid_;
  OccluderEdges edges_;
  EdgeTree rims_;
  EdgeTree folds_;
  BlockedRays rays_;
};

}  // namespace ocelli
