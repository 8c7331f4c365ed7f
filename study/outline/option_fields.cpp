#include "study/outline/option_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "oc_core/base/json_fields.h"
#include "study/outline/local_text.h"

namespace ocelli {
namespace {

constexpr size_t kMaxOptionsOfStudy = 20;
constexpr size_t kMaxOptionsOfAnalysis = 1000;
constexpr int kDigits = 9;

bool areDifferent(const std::vector<std::string>& texts) {
  return std::set<std::string>(texts.begin(), texts.end()).size() == texts.size();
}

/// Texts, or whole numbers, which are stored as they are written.
std::vector<std::string> readValues(JsonFields& fields, size_t count, size_t maxCharacters) {
  const nlohmann::json& list = fields.value("values");
  if (list.is_array() && list.size() == count &&
      std::ranges::all_of(list, [](const nlohmann::json& each) { return each.is_number_integer(); })) {
    std::vector<std::string> values;
    for (const nlohmann::json& each : list) {
      values.push_back(fmt::format("{}", each.get<int64_t>()));
    }
    return values;
  }
  return fields.texts("values", count, count, maxCharacters);
}

}  // namespace

void readOptions(JsonFields& fields, FormField& field, ProtocolReading reading, const std::string& language) {
  const bool byStudy = reading == ProtocolReading::kByStudy;
  const size_t maxOption = maxCharacters(reading, kMaxTitleCharacters);
  field.options = localTexts(fields, "options", byStudy ? 2 : 0, byStudy ? kMaxOptionsOfStudy : kMaxOptionsOfAnalysis,
                             maxOption, language);
  if (byStudy && !areDifferent(field.options)) {
    fields.fail("options", "must be different from each other");
  }
  if (fields.has("values")) {
    field.values = readValues(fields, field.options.size(), maxOption);
    if (byStudy && !areDifferent(field.values)) {
      fields.fail("values", "must be different from each other");
    }
  }
}

void readEnds(JsonFields& fields, FormField& field, ProtocolReading reading, const std::string& language) {
  if (fields.has("ends")) {
    field.ends = localTexts(fields, "ends", reading == ProtocolReading::kByStudy ? 2 : 0, 2,
                            maxCharacters(reading, kMaxTitleCharacters), language);
  }
}

std::optional<int> optionOfDigit(const FormField& field, Key key) {
  if (key < Key::k1 || key > Key::k9) {
    return std::nullopt;
  }
  const int option = static_cast<int>(key) - static_cast<int>(Key::k1);
  return option < static_cast<int>(field.options.size()) ? std::optional(option) : std::nullopt;
}

void pressOption(const FormField& field, QuestionEntry& entry, Key key) {
  const int last = static_cast<int>(field.options.size()) - 1;
  if (const std::optional<int> option = optionOfDigit(field, key)) {
    entry.chosen = {*option};
  } else if (key == Key::kRight) {
    entry.chosen = {entry.chosen.empty() ? 0 : std::min(entry.chosen.front() + 1, last)};
  } else if (key == Key::kLeft) {
    entry.chosen = {entry.chosen.empty() ? last : std::max(entry.chosen.front() - 1, 0)};
  }
}

void clickOption(const FormField& field, QuestionEntry& entry, const QuestionClick& click) {
  if (click.option >= 0 && click.option < static_cast<int>(field.options.size())) {
    entry.chosen = {click.option};
  }
}

std::optional<std::string> storedOption(const FormField& field, const QuestionEntry& entry) {
  return entry.chosen.empty() ? std::nullopt
                              : std::optional(storedOptions(field)[static_cast<size_t>(entry.chosen.front())]);
}

QuestionLook lookOfOption(const FormField& field, const QuestionEntry& entry) {
  QuestionLook look;
  for (int i = 0; i < static_cast<int>(field.options.size()); ++i) {
    look.options.push_back({field.options[static_cast<size_t>(i)], std::ranges::count(entry.chosen, i) > 0});
  }
  look.ends = field.ends;
  return look;
}

QuestionEntry randomOption(const FormField& field, Random& random) {
  return {{static_cast<int>(random.below(field.options.size()))}};
}

std::optional<QuestionStroke> strokeTowardsOption(const FormField& /*field*/, const QuestionEntry& entry,
                                                  const QuestionEntry& target) {
  if (target.chosen.empty() || entry.chosen == target.chosen) {
    return std::nullopt;
  }
  const int wanted = target.chosen.front();
  if (wanted < kDigits) {
    return QuestionStroke{static_cast<Key>(static_cast<int>(Key::k1) + wanted)};
  }
  // Before the first arrow that goes back, the last option is chosen.
  return QuestionStroke{entry.chosen.empty() || entry.chosen.front() > wanted ? Key::kLeft : Key::kRight};
}

void typeNothing(const FormField& /*field*/, QuestionEntry& /*entry*/, char32_t /*character*/) {}

void clickNothing(const FormField& /*field*/, QuestionEntry& /*entry*/, const QuestionClick& /*click*/) {}

std::optional<QuestionProblem> noProblem(const FormField& /*field*/, const QuestionEntry& /*entry*/) {
  return std::nullopt;
}

}  // namespace ocelli
