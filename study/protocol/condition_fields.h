// The field "conditions" of a protocol: the two view conditions that its study compares.
#pragma once

#include <string>

#include "study/task/scene_view.h"

namespace ocelli {

class JsonFields;

/// Pinhole ("ppc") and graph camera ("gc") where the field is missing. Throws InputError naming the field.
StudyConditions readConditions(JsonFields& fields);

/// Their names and labels alone, from the text of a protocol that has been read before, as a database holds it. Throws
/// InputError saying `where`.
ViewConditions conditionNamesOf(const std::string& protocolText, const std::string& where);

}  // namespace ocelli
