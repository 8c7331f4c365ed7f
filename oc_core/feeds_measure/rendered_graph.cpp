#include "oc_core/feeds_measure/rendered_graph.h"

#include "oc_core/image/color.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/render/rasterize_graph.h"

namespace ocelli {

RenderedGraph::RenderedGraph(const FeedGraph& graph, const Mesh& place) : graph_(graph), camera_(graph.camera()) {
  place_ = rasterize(camera_, place);
  colors_ = colorImage(place_, place, skyColor());
}

Image<Rgb8> RenderedGraph::draw(const Walkers& walkers, double seconds, WalkerAreas& areas) const {
  std::vector<uint8_t> walkerOfTriangle;
  const Mesh figures = walkers.meshAt(seconds, walkerOfTriangle);
  Image<glm::vec3> colors = colors_;
  if (!figures.empty()) {
    const FragmentImage seen = rasterize(camera_, figures);
    for (int y = 0; y < seen.height(); ++y) {
      for (int x = 0; x < seen.width(); ++x) {
        const Fragment& fragment = seen(x, y);
        const Fragment& behind = place_(x, y);
        if (!fragment.covered() || (behind.covered() && behind.t <= fragment.t)) {
          continue;
        }
        colors(x, y) = colorOf(fragment, figures);
        const glm::dvec3 point(positionOf(fragment, figures));
        areas[walkerOfTriangle[fragment.triangle]].add(frustumAt({x + 0.5, y + 0.5}, point), x, y);
      }
    }
  }
  return srgbFromLinear(colors);
}

/// Of the frusta that the ray of a pixel passes, the one in which a point of it lies.
size_t RenderedGraph::frustumAt(const glm::dvec2& pixel, const glm::dvec3& point) const {
  size_t last = GraphCamera::kRoot;
  for (const size_t i : graph_.chainAt(pixel)) {
    if (i != GraphCamera::kRoot && camera_.frusta()[i].plane.height(point) < 0) {
      break;
    }
    last = i;
  }
  return last;
}

}  // namespace ocelli
