// Reference images from other viewpoints, where a view tells what they get wrong: the space between its eye and what
// it shows is empty, so a surface there is a false skin, such as triangles that join samples across a gap which their
// own image does not tell from a slope.
#pragma once

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/render/fragment_image.h"
#include "oc_core/render/ray_target.h"

namespace ocelli {

class FreeSpaceTarget final : public RayTarget {
 public:
  static constexpr int kMaxSkins = 16;  ///< that a ray passes; it hits nothing after more

  /// `seen` is what the camera sees of the scene that the target stands for. All must outlive it.
  FreeSpaceTarget(const RayTarget& target, const PinholeCamera& camera, const FragmentImage& seen)
      : target_(target), camera_(camera), seen_(seen) {}

  /// The first hit that is not, by more than 1.5 footprints, before all that the view shows at the pixel and at the
  /// eight around it. The ray is straight: of two points.
  std::optional<Hit> hit(const RayPath& ray) const override;
  Box bounds() const override { return target_.bounds(); }

 private:
  bool isFree(const glm::vec3& point) const;

  const RayTarget& target_;
  const PinholeCamera& camera_;
  const FragmentImage& seen_;
};

}  // namespace ocelli
