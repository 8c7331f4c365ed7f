#include "oc_core/gl_rays/gl_ray_caster.h"

#include <utility>

#include "oc_core/gl_rays/gl_ray_walk.h"

namespace ocelli {
namespace {

class GlCastTarget final : public DepthRayCaster::Target {
 public:
  GlCastTarget(std::shared_ptr<GlContext> context, const DepthImageTarget& target)
      : context_(std::move(context)), target_(target) {
    const GlScope scope(*context_);
    walk_ = std::make_unique<GlRayWalk>(*context_, target);
  }

  void hits(std::span<const RayPath> rays, std::span<std::optional<Hit>> found,
            std::span<RayCost> costs) const override {
    const GlScope scope(*context_);
    castOnGpu(*context_, *walk_, target_, rays, found, costs);
  }

 private:
  std::shared_ptr<GlContext> context_;  ///< goes after the walk
  const DepthImageTarget& target_;
  std::unique_ptr<GlRayWalk> walk_;
};

}  // namespace

std::unique_ptr<DepthRayCaster::Target> GlRayCaster::prepare(const DepthImageTarget& target) const {
  return std::make_unique<GlCastTarget>(context_, target);
}

}  // namespace ocelli
