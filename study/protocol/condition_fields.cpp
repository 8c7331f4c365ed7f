#include "study/protocol/condition_fields.h"

#include "oc_core/base/json_fields.h"
#include "study/outline/condition_names.h"
#include "study/views/view_registry.h"

namespace ocelli {

StudyConditions readConditions(JsonFields& fields) {
  StudyConditions conditions;
  std::vector<std::shared_ptr<const SceneView>> views;
  conditions.names =
      readConditionNames(fields, [&](JsonFields& each, TrialView) { views.push_back(readSceneView(each, "view")); });
  if (!views.empty()) {
    conditions.views = std::move(views);
  }
  return conditions;
}

}  // namespace ocelli
