#include "oc_core/ambient/free_space_target.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ocelli {

bool FreeSpaceTarget::isFree(const glm::vec3& point) const {
  constexpr float kFootprints = 1.5f;
  const auto q = camera_.project(point);
  if (!q || !(q->u >= 1 && q->v >= 1 && q->u < static_cast<float>(camera_.width() - 1) &&
              q->v < static_cast<float>(camera_.height() - 1))) {
    return false;
  }
  const float behind = q->t + kFootprints * q->t / camera_.focalPixels();
  const auto x = static_cast<int>(q->u);
  const auto y = static_cast<int>(q->v);
  for (int j = y - 1; j <= y + 1; ++j) {
    for (int i = x - 1; i <= x + 1; ++i) {
      const Fragment& fragment = seen_(i, j);
      if (fragment.covered() && fragment.t <= behind) {
        return false;
      }
    }
  }
  return true;
}

std::optional<Hit> FreeSpaceTarget::hit(const RayPath& ray) const {
  // What a ray goes on by behind a skin, of its length.
  constexpr float kStep = 1e-4f;
  if (ray.size() < 2) {
    return std::nullopt;
  }
  const glm::vec3 way = ray[1] - ray[0];
  const float length = glm::length(way);
  float passed = 0;
  for (int skins = 0; skins <= kMaxSkins && passed < 1; ++skins) {
    std::optional<Hit> hit = target_.hit({ray[0] + way * passed, ray[1]});
    if (!hit) {
      return std::nullopt;
    }
    hit->t += passed * length;
    if (!isFree(hit->position)) {
      return hit;
    }
    passed = hit->t / length + kStep;
  }
  return std::nullopt;
}

}  // namespace ocelli
