#include "study/outline/condition_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "oc_core/base/json_fields.h"
#include "study/outline/study_factors.h"

namespace ocelli {
namespace {

constexpr size_t kMaxConditionCharacters = 100;

}  // namespace

ViewConditions readConditionNames(JsonFields& protocol, const ReadRestOfCondition& readRest) {
  std::vector<StudyFactor> factors = readFactors(protocol);
  if (!protocol.has("conditions")) {
    if (std::any_of(factors.begin(), factors.end(), [](const StudyFactor& factor) { return !factor.ofCases; })) {
      protocol.fail("factors",
                    "describes conditions, but the field \"conditions\" is missing: list them with their levels");
    }
    ViewConditions conditions = defaultConditions();
    conditions.factors = std::move(factors);
    return conditions;
  }
  const nlohmann::json& list = protocol.value("conditions");
  if (!list.is_array() || list.empty() || list.size() > kMaxConditions) {
    protocol.fail("conditions", fmt::format("must be a list of 1 to {} conditions, of which the first is the reference",
                                            kMaxConditions));
  }
  ViewConditions conditions;
  conditions.factors = std::move(factors);
  std::vector<JsonFields> all;
  protocol.forEach("conditions", 1, kMaxConditions, [&](JsonFields& each) {
    ViewCondition& condition = conditions.list.emplace_back();
    condition.name = each.shortText("name", kMaxConditionCharacters);
    condition.label = each.shortText("label", kMaxConditionCharacters, condition.name);
    condition.levels = readLevels(each, conditions.factors, FactorsOf::kConditions);
    readRest(each, conditionAt(all.size()));
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
