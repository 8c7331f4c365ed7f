// The effects that there are.
#pragma once

#include <string>
#include <vector>

#include "oc_core/shade/effect.h"

namespace ocelli {

/// In the order of lists. A new one is a row here.
const std::vector<Effect>& shadeEffects();

/// Throws InputError that lists them for another name.
const Effect& shadeEffect(const std::string& name);

}  // namespace ocelli
