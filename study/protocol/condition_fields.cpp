#include "study/protocol/condition_fields.h"

#include "oc_core/base/json_fields.h"
#include "study/outline/condition_names.h"
#include "study/views/view_registry.h"

namespace ocelli {

StudyConditions readConditions(JsonFields& fields) {
  StudyConditions conditions;
  conditions.names = readConditionNames(fields, [&](JsonFields& each, TrialView view) {
    conditions.views[static_cast<size_t>(view)] = readSceneView(each, "view");
  });
  return conditions;
}

}  // namespace ocelli
