// A number that is typed.
#include <fmt/format.h>

#include <cmath>

#include "oc_core/base/json_fields.h"
#include "oc_core/base/number_text.h"
#include "study/outline/local_text.h"
#include "study/outline/option_fields.h"
#include "study/outline/typed_entry.h"

namespace ocelli {
namespace {

constexpr double kMaxNumber = 1e9;
constexpr size_t kMaxDigits = 20;
/// Numbers as people write them are multiples of the step to rounding.
constexpr double kRounding = 1e-9;

void readNumberQuestion(JsonFields& fields, FormField& field, ProtocolReading reading, const std::string& language) {
  if (reading == ProtocolReading::kByAnalysis) {
    return;
  }
  field.least = fields.number("least", -kMaxNumber, kMaxNumber, field.least);
  field.most = fields.number("most", -kMaxNumber, kMaxNumber, field.most);
  field.step = fields.number("step", 1e-6, kMaxNumber, field.step);
  if (!(field.most > field.least)) {
    fields.fail("most", "must be more than \"least\"");
  }
  if (fields.has("unit")) {
    field.unit = localText(fields, "unit", kMaxTitleCharacters, language);
  }
}

/// Digits of other scripts are digits too.
char32_t plainDigit(char32_t character) {
  for (const char32_t zero : {U'\u0660', U'\u06f0', U'\uff10'}) {
    if (character >= zero && character < zero + 10) {
      return U'0' + (character - zero);
    }
  }
  const bool isPoint = character == U',' || character == U'\u066b' || character == U'\uff0e';
  return isPoint ? U'.' : character == U'\u2212' ? U'-' : character;
}

void typeNumber(const FormField& /*field*/, QuestionEntry& entry, char32_t character) {
  const char32_t plain = plainDigit(character);
  const bool isDigit = plain >= U'0' && plain <= U'9';
  const bool isPoint = plain == U'.' && entry.typed.find('.') == std::string::npos;
  const bool isSign = plain == U'-' && entry.typed.empty();
  if ((isDigit || isPoint || isSign) && entry.typed.size() < kMaxDigits) {
    entry.typed += static_cast<char>(plain);
  }
}

std::optional<double> numberOf(const FormField& field, const QuestionEntry& entry) {
  const std::optional<double> number = numberFromText<double>(entry.typed);
  if (!number || *number < field.least || *number > field.most) {
    return std::nullopt;
  }
  const double steps = *number / field.step;
  return std::abs(steps - std::round(steps)) <= kRounding * std::max(1.0, std::abs(steps)) ? number : std::nullopt;
}

std::optional<std::string> storedNumber(const FormField& field, const QuestionEntry& entry) {
  const std::optional<double> number = numberOf(field, entry);
  return number ? std::optional(fmt::format("{}", *number + 0.0)) : std::nullopt;
}

std::optional<QuestionProblem> problemOfNumber(const FormField& field, const QuestionEntry& entry) {
  if (numberOf(field, entry)) {
    return std::nullopt;
  }
  const bool isWhole = field.step == std::round(field.step);
  return QuestionProblem{isWhole ? "form_whole_number" : "form_number", fmt::format("{}", field.least),
                         fmt::format("{}", field.most)};
}

QuestionLook lookOfNumber(const FormField& field, const QuestionEntry& entry) {
  QuestionLook look;
  look.box = QuestionLook::Box{entry.typed, field.unit, false};
  return look;
}

QuestionEntry randomNumber(const FormField& field, Random& random) {
  constexpr double kMaxSteps = 1000;
  const double first = std::ceil(field.least / field.step - kRounding);
  const double steps = std::min(kMaxSteps, std::floor(field.most / field.step + kRounding) - first);
  QuestionEntry entry;
  const double number = (first + static_cast<double>(random.below(static_cast<size_t>(steps) + 1))) * field.step;
  entry.typed = fmt::format("{:.6f}", number);
  entry.typed.erase(entry.typed.find_last_not_of('0') + 1);
  if (entry.typed.ends_with('.')) {
    entry.typed.pop_back();
  }
  return entry;
}

}  // namespace

QuestionKind numberQuestion() {
  return {.name = "number",
          .description = "a number that is typed",
          .value = QuestionValue::kNumber,
          .read = readNumberQuestion,
          .press = pressTyped,
          .type = typeNumber,
          .click = clickNothing,
          .stored = storedNumber,
          .problem = problemOfNumber,
          .look = lookOfNumber,
          .atRandom = randomNumber,
          .towards = strokeTowardsTyped};
}

}  // namespace ocelli
