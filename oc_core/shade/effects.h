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

/// The ways that a list of an effect's ways offers, "traced" last. The effect may take others, such as files of
/// cameras.
std::vector<std::string> offeredWays(const Effect& effect);

}  // namespace ocelli
