#include "study/protocol/condition_fields.h"

#include <fmt/format.h>

#include <vector>

#include "oc_core/base/json_fields.h"
#include "study/protocol/protocol_fields.h"
#include "study/views/view_registry.h"

namespace ocelli {
namespace {

constexpr size_t kMaxConditionCharacters = 100;

/// The objects of the list, each with what messages call it.
std::vector<JsonFields> fieldsOfConditions(JsonFields& fields) {
  const nlohmann::json& list = fields.value("conditions");
  if (!list.is_array() || list.size() != kViews.size()) {
    fields.fail("conditions", "must be a list of two conditions, of which the first is the reference");
  }
  std::vector<JsonFields> each;
  for (size_t i = 0; i < list.size(); ++i) {
    each.emplace_back(list[i], fmt::format("{}, \"conditions\" {}", fields.where(), i + 1));
  }
  return each;
}

ViewConditions readNames(std::vector<JsonFields>& fields) {
  ViewConditions names;
  for (size_t i = 0; i < kViews.size(); ++i) {
    ViewCondition& condition = names.list[i];
    condition.name = readShortText(fields[i], "name", kMaxConditionCharacters);
    condition.label =
        fields[i].has("label") ? readShortText(fields[i], "label", kMaxConditionCharacters) : condition.name;
  }
  if (const std::optional<ViewConditions::Problem> problem = names.problem()) {
    fields[problem->index].fail(problem->field, problem->what);
  }
  return names;
}

}  // namespace

StudyConditions readConditions(JsonFields& fields) {
  StudyConditions conditions;
  if (!fields.has("conditions")) {
    return conditions;
  }
  std::vector<JsonFields> each = fieldsOfConditions(fields);
  conditions.names = readNames(each);
  for (size_t i = 0; i < each.size(); ++i) {
    conditions.views[i] = readSceneView(each[i], "view");
    each[i].rejectUnknown();
  }
  return conditions;
}

ViewConditions conditionNamesOf(const std::string& protocolText, const std::string& where) {
  const nlohmann::json json = parseJson(protocolText, where);
  JsonFields fields(json, where);
  if (!fields.has("conditions")) {
    return defaultConditions();
  }
  std::vector<JsonFields> each = fieldsOfConditions(fields);
  return readNames(each);
}

}  // namespace ocelli
