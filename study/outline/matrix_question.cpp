// Several rows with the same options each. Each row is answered, and stored, for itself.
#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/json_fields.h"
#include "study/outline/local_text.h"
#include "study/outline/option_fields.h"

namespace ocelli {
namespace {

constexpr size_t kMaxMatrixRows = 40;

void readMatrix(JsonFields& fields, FormField& field, ProtocolReading reading, const std::string& language) {
  readOptions(fields, field, reading, language);
  readEnds(fields, field, reading, language);
  fields.forEach(
      "rows", reading == ProtocolReading::kByStudy ? 1 : 0, kMaxMatrixRows,
      [&](JsonFields& each) {
        field.rows.push_back({readColumnName(each, "name", reading),
                              localText(each, "label", maxCharacters(reading, kMaxParagraphCharacters), language)});
        const std::string& name = field.rows.back().name;
        if (reading == ProtocolReading::kByStudy && std::ranges::count(field.rows, name, &QuestionRow::name) > 1) {
          fields.fail("rows", fmt::format("has two of the name \"{}\"", name));
        }
      },
      "rows");
}

}  // namespace

QuestionKind matrixQuestion() {
  return {.name = "matrix",
          .description = "several rows, each with one of the same options",
          .value = QuestionValue::kOption,
          .read = readMatrix,
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
