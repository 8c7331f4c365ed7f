#include "oc_core/depth_rays/graph_image_target.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/render/ray_segment.h"

namespace ocelli {

GraphImageTarget::GraphImageTarget(const GraphCamera& camera, const FragmentImage& fragments, const Mesh& mesh,
                                   const GraphDepthImage::Options& options)
    : image_(camera, fragments),
      options_(options),
      colors_(fragments.width(), fragments.height()),
      held_(fragments.width(), fragments.height()) {
  for (size_t i = 0; i < fragments.size(); ++i) {
    if (fragments[i].covered()) {
      ++samples_;
      held_[i] = 1;
      colors_[i] = colorOf(fragments[i], mesh);
      bounds_.add(positionOf(fragments[i], mesh));
    }
  }
}

std::optional<Hit> GraphImageTarget::hit(const RayPath& ray) const {
  RayCost ignored;
  return hit(ray, ignored);
}

std::optional<Hit> GraphImageTarget::hit(const RayPath& ray, RayCost& cost) const {
  return firstHit(ray, options_, cost);
}

std::optional<Hit> GraphImageTarget::hitPixelByPixel(const RayPath& ray, RayCost& cost) const {
  GraphDepthImage::Options fine = options_;
  fine.coarse = false;
  return firstHit(ray, fine, cost);
}

std::optional<Hit> GraphImageTarget::firstHit(const RayPath& ray, const GraphDepthImage::Options& options,
                                              RayCost& cost) const {
  for (size_t i = 1; i < ray.size(); ++i) {
    const glm::vec3 step = ray[i] - ray[i - 1];
    if (!castable(ray[i - 1], step)) {
      continue;
    }
    size_t steps = 0;
    const auto found = image_.intersect(glm::dvec3(ray[i - 1]), glm::dvec3(step), options, &steps);
    cost.cells += steps;
    const double length = glm::length(glm::dvec3(step));
    if (!found || found->distance > length * static_cast<double>(reachOf(ray, i))) {
      continue;
    }
    const double share = std::min(found->distance / length, 1.0);
    const glm::ivec2 pixel = shownPixel(found->place);
    Hit hit;
    hit.t = ray.tAt({i - 1, static_cast<float>(share)});
    hit.position = ray[i - 1] + step * static_cast<float>(share);
    hit.color = colors_(pixel.x, pixel.y);
    hit.element = static_cast<uint32_t>(colors_.index(pixel.x, pixel.y));
    return hit;
  }
  return std::nullopt;
}

glm::ivec2 GraphImageTarget::shownPixel(const glm::dvec2& place) const {
  const glm::ivec2 last(colors_.width() - 1, colors_.height() - 1);
  const glm::ivec2 own = glm::clamp(glm::ivec2(place), glm::ivec2(0), last);
  glm::ivec2 nearest = own;
  double least = std::numeric_limits<double>::infinity();
  for (int y = std::max(own.y - 1, 0); y <= std::min(own.y + 1, last.y); ++y) {
    for (int x = std::max(own.x - 1, 0); x <= std::min(own.x + 1, last.x); ++x) {
      const double distance = glm::distance(place, glm::dvec2(x + 0.5, y + 0.5));
      if (held_(x, y) != 0 && distance < least) {
        least = distance;
        nearest = {x, y};
      }
    }
  }
  return nearest;
}

double graphThickness(const Box& bounds) {
  return bounds.empty() ? 0 : static_cast<double>(glm::length(bounds.size())) / 600;
}

}  // namespace ocelli
