#include "tests/study_outline/question_examples.h"

#include "oc_core/base/json_fields.h"

namespace ocelli::test {

const std::vector<std::string>& questionExamples() {
  static const std::vector<std::string> examples{
      R"({"name": "scale", "question": "How hard was it?", "options": ["1", "2", "3", "4", "5"], "ends": ["easy", "hard"]})",
      R"({"name": "many", "question": "Which month?", "kind": "choice", "values": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12],
          "options": ["January", "February", "March", "April", "May", "June", "July", "August", "September", "October",
                      "November", "December"]})",
      R"({"name": "devices", "question": "What do you play with?", "kind": "multiple", "required": false,
          "options": ["mouse", "keyboard", "game pad", "none of these"], "values": ["mouse", "keys", "pad", "none"]})",
      R"({"name": "remarks", "question": "What else?", "kind": "text", "required": false, "max_characters": 40})",
      R"({"name": "age", "question": "How old are you?", "kind": "number", "least": 18, "most": 99, "unit": "years"})",
      R"({"name": "distance", "question": "How far was it?", "kind": "number", "least": -2, "most": 2, "step": 0.25})",
      R"({"name": "effort", "question": "How much effort was it?", "kind": "slider", "least": 0, "most": 100, "step": 5,
          "ends": ["very little", "very much"]})",
      R"({"name": "fine", "question": "How sure are you?", "kind": "slider", "least": 0, "most": 1, "step": 0.1,
          "ends": ["not at all", "fully"]})",
      R"({"name": "symptoms", "question": "How strongly do you feel this?", "kind": "matrix",
          "options": ["none", "slight", "severe"], "values": [0, 1, 3],
          "rows": [{"name": "head", "label": "Headache"}, {"name": "eyes", "label": "Strained eyes"}]})"};
  return examples;
}

FormField questionExample(const std::string& json) {
  const JsonDocument document(json, "example");
  JsonFields fields(document);
  FormField field = readFormField(fields, defaultConditions(), ProtocolReading::kByStudy);
  fields.rejectUnknown();
  return field;
}

}  // namespace ocelli::test
