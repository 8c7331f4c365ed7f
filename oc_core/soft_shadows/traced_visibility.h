// The visibility of an area light by shadow rays: Monte Carlo over strata of the light. With 1,024 rays it is the truth
// that other ways are compared with.
#pragma once

#include "oc_core/render/blocked_rays.h"
#include "oc_core/soft_shadows/area_visibility.h"

namespace ocelli {

class TracedVisibility final : public AreaVisibility {
 public:
  static constexpr int kMaxRays = 4096;

  /// The occluders must outlive it. `rays` a receiver, which lie in strata of equal area: rounded down to a product of
  /// two numbers that differ as little as the sides of the light allow.
  TracedVisibility(const Mesh& occluders, const AreaLight& light, int rays, const ReceiverLift& lift = {});

  LightVisibility of(std::span<const ShadowReceiver> receivers) const override;

  /// Places on the light in a stratum, `jitter` from 0 to 1; in its frame.
  static glm::vec3 onLight(const LightFrame& frame, const glm::vec2& unit);

 private:
  const LightFrame frame_;
  ReceiverLift lift_;
  int columns_ = 1;
  int rows_ = 1;
  BlockedRays rays_;
};

}  // namespace ocelli
