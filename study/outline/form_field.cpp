#include "study/outline/form_field.h"

#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/json_fields.h"
#include "study/outline/local_text.h"
#include "study/outline/question_kinds.h"

namespace ocelli {
namespace {

constexpr size_t kMaxColumnName = 60;

/// Two conditions, in either order.
std::vector<TrialView> readFavors(JsonFields& fields, const ViewConditions& conditions) {
  const nlohmann::json& list = fields.value("favors");
  std::vector<TrialView> favors;
  for (size_t i = 0; list.is_array() && i < list.size(); ++i) {
    if (const auto view = list[i].is_string() ? conditions.viewNamed(list[i].get<std::string>()) : std::nullopt) {
      favors.push_back(*view);
    }
  }
  if (!list.is_array() || list.size() != 2 || favors.size() != 2 || favors[0] == favors[1]) {
    if (!conditions.isPair()) {
      fields.fail("favors", fmt::format("must be a list of two conditions, of {}: the one that the first option speaks "
                                        "for, and that of the last",
                                        conditions.namesText("and")));
    }
    const ViewCondition& reference = conditions.list[0];
    const ViewCondition& other = conditions.list[1];
    fields.fail("favors",
                fmt::format(R"(must be ["{0}", "{1}"] or ["{1}", "{0}"]: the condition that the first option )"
                            "speaks for, and that of the last",
                            reference.name, other.name));
  }
  return favors;
}

std::string readKind(JsonFields& fields, ProtocolReading reading) {
  const std::string usual = questionKinds().front().name;
  if (reading == ProtocolReading::kByAnalysis) {
    return fields.text("kind", usual);
  }
  std::vector<std::string> names;
  for (const QuestionKind& kind : questionKinds()) {
    names.push_back(kind.name);
  }
  return fields.choice("kind", names, usual);
}

}  // namespace

std::string readColumnName(JsonFields& fields, const std::string& name, ProtocolReading reading) {
  std::string text = fields.shortText(name, maxCharacters(reading, kMaxColumnName));
  const auto isAllowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  if (reading == ProtocolReading::kByStudy &&
      (!std::ranges::all_of(text, isAllowed) || !(text.front() >= 'a' && text.front() <= 'z'))) {
    fields.fail(name, "must be of small letters, digits and _, and begin with a letter, as it names a column");
  }
  return text;
}

FormField readFormField(JsonFields& fields, const ViewConditions& conditions, ProtocolReading reading,
                        const std::string& language) {
  const size_t maxQuestion = maxCharacters(reading, kMaxParagraphCharacters);
  FormField field;
  field.name = readColumnName(fields, "name", reading);
  field.question = reading == ProtocolReading::kByStudy
                       ? localText(fields, "question", maxQuestion, language)
                       : localText(fields, "question", maxQuestion, language, field.name);
  field.kind = readKind(fields, reading);
  field.required = fields.boolean("required", field.required);
  questionKind(field.kind).read(fields, field, reading, language);
  if (fields.has("favors")) {
    if (questionKind(field.kind).name != questionKinds().front().name) {
      fields.fail("favors", "is of questions of the kind \"" + questionKinds().front().name + "\" alone");
    }
    field.favors = readFavors(fields, conditions);
  }
  return field;
}

}  // namespace ocelli
