// The names, labels and levels of factors of the conditions of a study: the fields "conditions" and "factors" of its
// protocol.
#pragma once

#include <functional>
#include <string>

#include "study/trial/view_condition.h"

namespace ocelli {

class JsonFields;

/// What a protocol says of a condition beside its name, label and levels.
using ReadRestOfCondition = std::function<void(JsonFields& fields, TrialView view)>;

/// defaultConditions() where the field is missing. Throws InputError naming the field.
ViewConditions readConditionNames(JsonFields& protocol, const ReadRestOfCondition& readRest);

/// The same from the text of a protocol that has been read before, as a database holds it. Throws InputError saying
/// `where`.
ViewConditions conditionNamesOf(const std::string& protocolText, const std::string& where);

}  // namespace ocelli
