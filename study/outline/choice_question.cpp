// One of several options; between `ends` they are a scale.
#include "study/outline/option_fields.h"

namespace ocelli {
namespace {

void readChoice(JsonFields& fields, FormField& field, ProtocolReading reading, const std::string& language) {
  readOptions(fields, field, reading, language);
  readEnds(fields, field, reading, language);
}

}  // namespace

QuestionKind choiceQuestion() {
  return {.name = "choice",
          .description = "one of several options",
          .value = QuestionValue::kOption,
          .read = readChoice,
          .press = pressOption,
          .type = typeNothing,
          .click = clickOption,
          .stored = storedOption,
          .problem = noProblem,
          .look = lookOfOption,
          .atRandom = randomOption,
          .towards = strokeTowardsOption};
}

}  // namespace ocelli
