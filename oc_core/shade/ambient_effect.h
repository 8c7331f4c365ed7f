// Ambient light (section 4.3.4.4): how much of an even sky reaches the surfaces of a scene.
#pragma once

#include "oc_core/shade/effect.h"

namespace ocelli {

Effect ambientEffect();

}  // namespace ocelli
