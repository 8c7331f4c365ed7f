// Hits of the CPU and of the GPU, side by side.
#pragma once

#include <algorithm>
#include <vector>

#include "oc_core/depth_rays/depth_image_target.h"

namespace ocelli::test {

struct CastHits {
  explicit CastHits(size_t count) : hits(count), costs(count) {}
  std::vector<std::optional<Hit>> hits;
  std::vector<RayCost> costs;
};

inline CastHits castOnCpu(const DepthImageTarget& target, const std::vector<RayPath>& rays) {
  CastHits cast(rays.size());
  for (size_t i = 0; i < rays.size(); ++i) {
    cast.hits[i] = target.hit(rays[i], cast.costs[i]);
  }
  return cast;
}

inline size_t metCount(const CastHits& cast) {
  return static_cast<size_t>(
      std::count_if(cast.hits.begin(), cast.hits.end(), [](const auto& hit) { return hit.has_value(); }));
}

/// Rays of which one side alone hits something, or that hit at another place, or see another colour.
inline size_t differingHits(const CastHits& a, const CastHits& b) {
  // Distances of 10 and less are rounded by 1e-6; a few operations each.
  constexpr float kNear = 1e-5f;
  constexpr float kGrey = 1.0f / 255;
  size_t differing = 0;
  for (size_t i = 0; i < a.hits.size(); ++i) {
    const std::optional<Hit>& p = a.hits[i];
    const std::optional<Hit>& q = b.hits[i];
    const glm::vec3 step = p && q ? glm::abs(p->color - q->color) : glm::vec3(0);
    differing += p.has_value() != q.has_value() ||
                 (p && (std::abs(p->t - q->t) > kNear || glm::distance(p->position, q->position) > kNear ||
                        std::max({step.x, step.y, step.z}) > kGrey));
  }
  return differing;
}

}  // namespace ocelli::test
