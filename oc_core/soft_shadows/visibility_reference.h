// The slow, obvious visibility of an area light: every triangle against every line to a sample of the light. What tests
// compare the fast ways with.
#pragma once

#include "oc_core/soft_shadows/area_visibility.h"
#include "oc_core/soft_shadows/light_grid.h"

namespace ocelli {

/// Of one receiver: which samples of a grid of `gridSide` rows it sees, as their share. 0 where the light does not
/// shine at it.
float visibilitySlowly(const Mesh& occluders, const AreaLight& light, const ShadowReceiver& receiver, int gridSide = 32,
                       const ReceiverLift& lift = {});

}  // namespace ocelli
