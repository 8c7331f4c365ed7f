#include "study/outline/condition_names.h"

#include <vector>

#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr size_t kMaxConditionCharacters = 100;

}  // namespace

ViewConditions readConditionNames(JsonFields& protocol, const ReadRestOfCondition& readRest) {
  if (!protocol.has("conditions")) {
    return defaultConditions();
  }
  const nlohmann::json& list = protocol.value("conditions");
  if (!list.is_array() || list.size() != kViews.size()) {
    protocol.fail("conditions", "must be a list of two conditions, of which the first is the reference");
  }
  ViewConditions conditions;
  std::vector<JsonFields> all;
  protocol.forEach("conditions", kViews.size(), kViews.size(), [&](JsonFields& each) {
    ViewCondition& condition = conditions.list[all.size()];
    condition.name = each.shortText("name", kMaxConditionCharacters);
    condition.label = each.shortText("label", kMaxConditionCharacters, condition.name);
    readRest(each, kViews[all.size()]);
    all.push_back(each);
  });
  if (const std::optional<ViewConditions::Problem> problem = conditions.problem()) {
    all[problem->index].fail(problem->field, problem->what);
  }
  return conditions;
}

ViewConditions conditionNamesOf(const std::string& protocolText, const std::string& where) {
  const JsonDocument document(protocolText, where);
  JsonFields protocol(document, UnknownFields::kIgnored);
  return readConditionNames(protocol, [](JsonFields&, TrialView) {});
}

}  // namespace ocelli
