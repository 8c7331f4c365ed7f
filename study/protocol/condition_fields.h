// The field "conditions" of a protocol: the conditions of its study, and what each shows.
#pragma once

#include "study/task/scene_view.h"

namespace ocelli {

class JsonFields;

/// Pinhole ("ppc") and graph camera ("gc") where the field is missing. Throws InputError naming the field.
StudyConditions readConditions(JsonFields& fields);

}  // namespace ocelli
