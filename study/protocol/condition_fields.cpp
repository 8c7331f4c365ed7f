#include "study/protocol/condition_fields.h"

#include <fmt/format.h>

#include <functional>
#include <vector>

#include "oc_core/base/json_fields.h"
#include "study/protocol/protocol_fields.h"
#include "study/views/view_registry.h"

namespace ocelli {
namespace {

constexpr size_t kMaxConditionCharacters = 100;

/// Calls `readRest` for each condition, by its index, when its name and label are read.
ViewConditions readNames(JsonFields& fields, const std::function<void(JsonFields& each, size_t index)>& readRest) {
  const nlohmann::json& list = fields.value("conditions");
  if (!list.is_array() || list.size() != kViews.size()) {
    fields.fail("conditions", "must be a list of two conditions, of which the first is the reference");
  }
  ViewConditions names;
  std::vector<JsonFields> all;
  fields.forEach("conditions", kViews.size(), kViews.size(), [&](JsonFields& each) {
    ViewCondition& condition = names.list[all.size()];
    condition.name = each.shortText("name", kMaxConditionCharacters);
    condition.label = each.shortText("label", kMaxConditionCharacters, condition.name);
    readRest(each, all.size());
    all.push_back(each);
  });
  if (const std::optional<ViewConditions::Problem> problem = names.problem()) {
    all[problem->index].fail(problem->field, problem->what);
  }
  return names;
}

}  // namespace

StudyConditions readConditions(JsonFields& fields) {
  StudyConditions conditions;
  if (!fields.has("conditions")) {
    return conditions;
  }
  conditions.names =
      readNames(fields, [&](JsonFields& each, size_t index) { conditions.views[index] = readSceneView(each, "view"); });
  return conditions;
}

ViewConditions conditionNamesOf(const std::string& protocolText, const std::string& where) {
  const JsonDocument document(protocolText, where);
  JsonFields fields(document, UnknownFields::kIgnored);
  if (!fields.has("conditions")) {
    return defaultConditions();
  }
  return readNames(fields, [](JsonFields&, size_t) {});
}

}  // namespace ocelli
