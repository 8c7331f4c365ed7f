// What a simulated observer answers to the questions of forms.
#pragma once

#include <array>
#include <map>
#include <string>

#include "study/agent/task_policy.h"
#include "study/protocol/protocol.h"

namespace ocelli {

/// How hard the trials of each task were to a subject, in each condition (TaskPolicy::effort()).
using Efforts = std::array<Effort, kMaxConditions>;
using Experience = std::map<std::string, Efforts>;

/// The option of a field. A scale from one condition to another, about a task whose name stands in its name or
/// question, is answered by how hard the subject found it in either view, and in the middle where it did both views
/// alike: people notice differences of about a tenth. Other questions are answered at random, but one that exclusions
/// are about by its first option that excludes nobody.
int optionOf(const Protocol& protocol, const ProtocolForm& form, int field, const Experience& experience,
             Random& random);

}  // namespace ocelli
