// Back-projection of a plain shadow map, a peer: G. Guennebaud, L. Barthe and M. Paulin, Real-time soft shadow mapping
// by backprojection, EGSR 2006, with the bit masks of M. Schwarz and M. Stamminger, Bitmask soft shadows, Eurographics
// 2007, in place of summed areas, which count twice where occluders overlap.
//
// Each texel that is nearer than the receiver is a square parallel to the light, as large as the texel there, and is
// projected from the receiver onto the light, whose samples in it are hidden. Gaps are filled as Guennebaud et al. do:
// a square grows to its neighbours to the right and below where these are nearer than the receiver, too. Squares that
// project beside the light are left out by the least depths of squares of texels (their hierarchical shadow map).
#pragma once

#include "oc_core/soft_shadows/area_visibility.h"
#include "oc_core/soft_shadows/light_grid.h"
#include "oc_core/soft_shadows/light_shadow_map.h"

namespace ocelli {

struct BackprojectionOptions {
  int gridSide = 32;  ///< of the samples of the light
  ReceiverLift lift = {};
};

class BackprojectedShadows final : public AreaVisibility {
 public:
  BackprojectedShadows(const LightShadowMap& map, const AreaLight& light, const BackprojectionOptions& options = {});
  LightVisibility of(std::span<const ShadowReceiver> receivers) const override;

 private:
  LightShadowMap map_;
  LightFrame frame_;
  BackprojectionOptions options_;
  LightGrid grid_;
};

}  // namespace ocelli
