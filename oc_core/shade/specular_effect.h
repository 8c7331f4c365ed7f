// Reflection and refraction (section 3.5.2.3.1): one ray a pixel goes on from what mirrors or refracts.
#pragma once

#include "oc_core/shade/effect.h"

namespace ocelli {

Effect reflectionEffect();
Effect refractionEffect();

}  // namespace ocelli
