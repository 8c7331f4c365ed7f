// What a power analysis supposes of a contrast of conditions: effects of conditions that a file gives, and what they
// make of the contrast.
#pragma once

#include <string>
#include <vector>

#include "analysis/power/power_effects.h"

namespace ocelli {

/// With the effects of the file; `reference` is 1 and `other` the ratio of times or odds. Throws InputError where there
/// is no file, for options that are only for two conditions, and where the protocol cannot tell the contrast.
Truth contrastTruth(const Protocol& protocol, const SupposedEffects& supposed, const PlannedModel& model,
                    const PlannedContrast& contrast);
/// The same without a difference of any two conditions.
Truth contrastTruthWithoutEffect(const Protocol& protocol, const std::string& task, const Truth& wanted);

/// Levels of all conditions, how subjects and cases differ, in lines for a reader.
std::vector<std::string> describeContrastTruth(const Protocol& protocol, const Truth& truth, const std::string& task);

}  // namespace ocelli
