#include "study/outline/form_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr size_t kMaxColumnName = 60;
constexpr size_t kMaxOptionsOfStudy = 20;
constexpr size_t kMaxOptionsOfAnalysis = 1000;

/// What names columns of tables: "age_band".
void checkColumnName(const JsonFields& fields, const std::string& name) {
  const auto isAllowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  if (!std::all_of(name.begin(), name.end(), isAllowed) || !(name.front() >= 'a' && name.front() <= 'z')) {
    fields.fail("name", "must be of small letters, digits and _, and begin with a letter, as it names a column");
  }
}

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

}  // namespace

FormField readFormField(JsonFields& fields, const ViewConditions& conditions, ProtocolReading reading) {
  const bool byStudy = reading == ProtocolReading::kByStudy;
  const size_t maxOption = maxCharacters(reading, kMaxTitleCharacters);
  const size_t maxQuestion = maxCharacters(reading, kMaxParagraphCharacters);
  FormField field;
  field.name = fields.shortText("name", maxCharacters(reading, kMaxColumnName));
  if (byStudy) {
    checkColumnName(fields, field.name);
  }
  field.question =
      byStudy ? fields.shortText("question", maxQuestion) : fields.shortText("question", maxQuestion, field.name);
  field.options =
      fields.texts("options", byStudy ? 2 : 0, byStudy ? kMaxOptionsOfStudy : kMaxOptionsOfAnalysis, maxOption);
  if (byStudy && std::set<std::string>(field.options.begin(), field.options.end()).size() != field.options.size()) {
    fields.fail("options", "must be different from each other");
  }
  if (fields.has("ends")) {
    field.ends = fields.texts("ends", byStudy ? 2 : 0, 2, maxOption);
  }
  if (fields.has("favors")) {
    field.favors = readFavors(fields, conditions);
  }
  return field;
}

}  // namespace ocelli
