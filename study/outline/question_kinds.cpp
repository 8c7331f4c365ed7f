#include "study/outline/question_kinds.h"

#include <algorithm>

#include "oc_core/base/check.h"

namespace ocelli {

QuestionKind choiceQuestion();
QuestionKind multipleQuestion();
QuestionKind textQuestion();
QuestionKind numberQuestion();
QuestionKind sliderQuestion();
QuestionKind matrixQuestion();

const std::vector<QuestionKind>& questionKinds() {
  static const std::vector<QuestionKind> kinds{choiceQuestion(), multipleQuestion(), textQuestion(),
                                               numberQuestion(), sliderQuestion(),   matrixQuestion()};
  return kinds;
}

bool isQuestionKind(std::string_view name) {
  return std::ranges::any_of(questionKinds(), [&](const QuestionKind& kind) { return kind.name == name; });
}

const QuestionKind& questionKind(std::string_view name) {
  const std::vector<QuestionKind>& kinds = questionKinds();
  const auto found = std::ranges::find(kinds, isQuestionKind(name) ? name : "text", &QuestionKind::name);
  OC_CHECK(found != kinds.end(), "there are texts");
  return *found;
}

const char* nameOf(QuestionValue value) {
  switch (value) {
    case QuestionValue::kOption:
      return "option";
    case QuestionValue::kOptions:
      return "options";
    case QuestionValue::kText:
      return "text";
    case QuestionValue::kNumber:
      return "number";
  }
  return "";
}

std::vector<QuestionItem> itemsOf(const std::vector<FormField>& fields) {
  std::vector<QuestionItem> items;
  for (size_t i = 0; i < fields.size(); ++i) {
    const FormField& field = fields[i];
    if (field.rows.empty()) {
      items.push_back({static_cast<int>(i), field.name, field.question});
    }
    for (const QuestionRow& row : field.rows) {
      items.push_back({static_cast<int>(i), field.name + "_" + row.name, row.label});
    }
  }
  return items;
}

const std::vector<std::string>& storedOptions(const FormField& field) {
  return field.values.empty() ? field.options : field.values;
}

}  // namespace ocelli
