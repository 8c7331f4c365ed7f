// A device that is the CPU.
#pragma once

#include "oc_core/depth_rays/depth_ray_caster.h"

namespace ocelli::test {

class CpuCaster final : public DepthRayCaster {
 public:
  std::unique_ptr<Target> prepare(const DepthImageTarget& target) const override {
    return std::make_unique<CpuTarget>(target);
  }
  std::string description() const override { return "the CPU"; }

 private:
  class CpuTarget final : public Target {
   public:
    explicit CpuTarget(const DepthImageTarget& target) : target_(target) {}
    void hits(std::span<const RayPath> rays, std::span<std::optional<Hit>> found,
              std::span<RayCost> costs) const override {
      for (size_t i = 0; i < rays.size(); ++i) {
        found[i] = target_.hit(rays[i], costs[i]);
      }
    }

   private:
    const DepthImageTarget& target_;
  };
};

}  // namespace ocelli::test
