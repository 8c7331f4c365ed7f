// The graph camera's own image of a scene with walkers: what the composed image of its feeds should be.
#pragma once

#include "oc_core/feeds/feed_graph.h"
#include "oc_core/feeds_measure/walker_fates.h"
#include "oc_core/feeds_measure/walkers.h"
#include "oc_core/image/png_file.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli {

class RenderedGraph {
 public:
  /// Draws the place once. `graph` must outlive it.
  RenderedGraph(const FeedGraph& graph, const Mesh& place);

  /// With the walkers as they are at a time; adds the pixels of each to its area.
  Image<Rgb8> draw(const Walkers& walkers, double seconds, WalkerAreas& areas) const;

 private:
  size_t frustumAt(const glm::dvec2& pixel, const glm::dvec3& point) const;

  const FeedGraph& graph_;
  GraphCamera camera_;
  FragmentImage place_;
  Image<glm::vec3> colors_;
};

}  // namespace ocelli
