#include "oc_core/ambient/unseen_target.h"

namespace ocelli {

std::optional<Hit> UnseenTarget::hit(const RayPath& ray) const {
  constexpr float kFootprints = 1.5f;
  const std::optional<Hit> hit = target_.hit(ray);
  if (!hit) {
    return hit;
  }
  const auto q = camera_.project(hit->position);
  const bool within = q && q->u >= 0 && q->v >= 0 && q->u < static_cast<float>(camera_.width()) &&
                      q->v < static_cast<float>(camera_.height());
  if (!within) {
    return hit;
  }
  const Fragment& fragment = seen_(static_cast<int>(q->u), static_cast<int>(q->v));
  const bool isSeen = fragment.covered() && q->t - fragment.t <= kFootprints * q->t / camera_.focalPixels();
  return isSeen ? std::nullopt : hit;
}

}  // namespace ocelli
