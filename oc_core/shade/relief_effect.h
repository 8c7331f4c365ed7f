// `ocelli shade --effect relief`: objects with the role `relief` drawn as relief tiles, one image each (section
// 3.5.2.3.2; oc_core/relief).
#pragma once

#include "oc_core/shade/effect.h"

namespace ocelli {

Effect reliefEffect();

}  // namespace ocelli
