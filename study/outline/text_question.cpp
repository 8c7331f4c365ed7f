// A text in the subject's own words.
#include <string_view>

#include "oc_core/base/json_fields.h"
#include "study/outline/option_fields.h"
#include "study/outline/typed_entry.h"

namespace ocelli {
namespace {

constexpr int kMaxOwnWords = 4000;

void readTextQuestion(JsonFields& fields, FormField& field, ProtocolReading reading, const std::string& /*language*/) {
  if (reading == ProtocolReading::kByStudy) {
    field.maxCharacters = fields.integer("max_characters", 1, kMaxOwnWords, field.maxCharacters);
  }
}

void typeText(const FormField& field, QuestionEntry& entry, char32_t character) {
  const bool isControl = character < 0x20 || (character >= 0x7f && character < 0xa0);
  const bool leads = entry.typed.empty() && character == U' ';
  if (!isControl && !leads && character <= 0x10ffff &&
      countUtf8(entry.typed) < static_cast<size_t>(field.maxCharacters)) {
    appendUtf8(entry.typed, character);
  }
}

/// Without spaces at its end.
std::optional<std::string> storedText(const FormField& /*field*/, const QuestionEntry& entry) {
  const size_t end = entry.typed.find_last_not_of(' ');
  return end == std::string::npos ? std::nullopt : std::optional(entry.typed.substr(0, end + 1));
}

QuestionLook lookOfText(const FormField& /*field*/, const QuestionEntry& entry) {
  QuestionLook look;
  look.box = QuestionLook::Box{entry.typed, "", true};
  return look;
}

QuestionEntry randomText(const FormField& field, Random& random) {
  constexpr std::array<std::string_view, 4> kTexts{"nothing to add", "it went well", "hard at first", "fine"};
  QuestionEntry entry;
  entry.typed = kTexts[random.below(kTexts.size())].substr(0, static_cast<size_t>(field.maxCharacters));
  return entry;
}

}  // namespace

QuestionKind textQuestion() {
  return {.name = "text",
          .description = "a text in the subject's own words",
          .value = QuestionValue::kText,
          .read = readTextQuestion,
          .press = pressTyped,
          .type = typeText,
          .click = clickNothing,
          .stored = storedText,
          .problem = noProblem,
          .look = lookOfText,
          .atRandom = randomText,
          .towards = strokeTowardsTyped};
}

}  // namespace ocelli
