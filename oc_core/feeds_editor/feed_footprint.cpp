#include "oc_core/feeds_editor/feed_footprint.h"

#include <array>
#include <glm/geometric.hpp>

#include "oc_core/feeds/feed_graph.h"

namespace ocelli {
namespace {

constexpr int kSteps = 8;  ///< of each border of the image

}  // namespace

std::vector<glm::dvec2> footprintOf(const FeedSetup& setup, size_t index) {
  const Feed& feed = setup.feeds[index];
  const glm::dvec2 eye(feed.pose.eye.x, feed.pose.eye.z);
  const double above = feed.pose.eye.y - setup.floorHeight;
  std::vector<glm::dvec2> outline;
  const auto add = [&](double x, double y) {
    const auto ray = feedRayOf(feed, glm::dvec2(x * feed.width, y * feed.height));
    if (!ray) {
      return;
    }
    const glm::dvec2 level(ray->x, ray->z);
    const double length = glm::length(level);
    if (!(length > 0)) {
      outline.push_back(eye);
      return;
    }
    const double reach = ray->y < 0 && above > 0 ? above / -ray->y * length : kMaxFootprint;
    outline.push_back(eye + level / length * std::min(reach, kMaxFootprint));
  };
  for (int i = 0; i <= kSteps; ++i) {
    add(static_cast<double>(i) / kSteps, 0);
  }
  for (int i = kSteps; i >= 0; --i) {
    add(static_cast<double>(i) / kSteps, 1);
  }
  return outline;
}

}  // namespace ocelli
