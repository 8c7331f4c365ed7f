// Percentage-closer soft shadows, a peer: R. Fernando, Percentage-closer soft shadows, SIGGRAPH 2005 sketches.
//
//   1. Blocker search: the mean depth of the texels nearer than the receiver, where lines from it to the light pass the
//      plane of the nearest occluder.
//   2. Penumbra width, as if all blockers were one plane at that depth, parallel to the light.
//   3. Percentage-closer filtering: the share of texels in a window of that width that are not nearer than the
//   receiver.
//
// Depths are compared with those of the receiver's own plane at each texel, so that wide windows do not shade surfaces
// that lean. It is right for one blocker parallel to the light; where blockers at several depths overlap, the mean
// stands for none of them.
#pragma once

#include "oc_core/soft_shadows/area_visibility.h"
#include "oc_core/soft_shadows/light_shadow_map.h"

namespace ocelli {

struct PercentageCloserOptions {
  int searchTaps = 16;  ///< a side: their square is looked up
  int filterTaps = 16;
  ReceiverLift lift = {};
};

class PercentageCloserShadows final : public AreaVisibility {
 public:
  PercentageCloserShadows(const LightShadowMap& map, const AreaLight& light,
                          const PercentageCloserOptions& options = {});
  LightVisibility of(std::span<const ShadowReceiver> receivers) const override;

 private:
  LightShadowMap map_;
  LightFrame frame_;
  PercentageCloserOptions options_;
};

}  // namespace ocelli
