// Of what hides light, that which a view does not show: what no depth buffer of the view can know.
#pragma once

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/render/fragment_image.h"
#include "oc_core/render/ray_target.h"

namespace ocelli {

class UnseenTarget final : public RayTarget {
 public:
  /// `seen` is what the camera sees of the target. All must outlive it.
  UnseenTarget(const RayTarget& target, const PinholeCamera& camera, const FragmentImage& seen)
      : target_(target), camera_(camera), seen_(seen) {}

  /// The target's first hit, where the view does not show that place: where it lies beyond the borders, or more than
  /// 1.5 footprints behind what its pixel shows.
  std::optional<Hit> hit(const RayPath& ray) const override;
  Box bounds() const override { return target_.bounds(); }

 private:
  const RayTarget& target_;
  const PinholeCamera& camera_;
  const FragmentImage& seen_;
};

}  // namespace ocelli
