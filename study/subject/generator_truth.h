// What the effects of the data-only subject (data_generator.h) come to in the trials of a protocol: typical times, how
// often answers are right among all subjects and cases, and mean errors of estimates.
#pragma once

#include <string>

#include "study/protocol/protocol.h"
#include "study/subject/generator_effects.h"

namespace ocelli {

/// Of a task whose outcome is a time: exp() of the mean of log seconds over all its trials in the protocol, had they
/// this view and no limit. Throws InputError where the protocol has none, as below.
double geometricMeanSeconds(const Protocol& protocol, const GeneratorEffects& effects, const std::string& task,
                            TrialView view);

/// Of a task whose outcome is an answer: the share of right ones over all its trials in the protocol, had they this
/// view, and over the normal effects of subjects and cases.
double shareRight(const Protocol& protocol, const GeneratorEffects& effects, const std::string& task, TrialView view);

/// Of a task whose outcome is an estimate: the mean of signed errors over all its trials in the protocol, had they this
/// view, as study/trial/estimated_value.h has them.
double meanError(const Protocol& protocol, const GeneratorEffects& effects, const std::string& task, TrialView view);

}  // namespace ocelli
