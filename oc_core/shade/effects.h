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

/// What a user sets, "NAME=VALUE" each. Throws InputError for a name that the effect does not have, one that is given
/// twice, and for a value that is no number or out of range.
std::map<std::string, double> effectOptions(const Effect& effect, const std::vector<std::string>& texts);

}  // namespace ocelli
