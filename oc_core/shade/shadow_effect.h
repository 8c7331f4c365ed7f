// The effect `shadow`: a scene lit by an area light, whose soft shadows come from what hides it (section 3.5.3).
#pragma once

#include "oc_core/shade/effect.h"

namespace ocelli {

Effect shadowEffect();

}  // namespace ocelli
