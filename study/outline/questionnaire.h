// Questionnaires that the program has: forms as data, with how they are scored (protocols/questionnaires/NAME.json).
// A file stays as it is once studies have used it: one that asks or scores otherwise gets another name.
//
// Recipe for a further questionnaire: protocols/questionnaires/NAME.json, and its name in study/outline/CMakeLists.txt.
// protocols/questionnaire.schema.json lists the fields; tests/study_outline/questionnaire_test.cpp reads each file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/outline/form_outline.h"

namespace ocelli {

/// A sum of answers that are numbers: factor x (constant + the sum of weight x answer) / divisor.
struct QuestionnaireScore {
  std::string name;   ///< "nausea"
  std::string title;  ///< "SSQ nausea"
  double factor = 1;
  double divisor = 1;
  double constant = 0;
  std::map<std::string, double> weights;  ///< by the name of the item
  double least = 0;                       ///< that it can be
  double most = 100;
};

struct Questionnaire {
  std::string name;    ///< "ssq"
  std::string source;  ///< where it was published
  ProtocolForm form;   ///< in a language
  std::vector<QuestionnaireScore> scores;
};

/// In the language, or in English where it has no texts of it; nothing for a name that no questionnaire has.
std::optional<Questionnaire> findQuestionnaire(const std::string& name, const std::string& language);
std::vector<std::string> questionnaireNames();
/// Throws InputError naming `where` and the field.
Questionnaire questionnaireFromJsonText(const std::string& text, const std::string& where, const std::string& language);

/// Of answers by item. Nothing where an item that counts has no answer: a missing answer is not zero.
std::optional<double> scoreOf(const QuestionnaireScore& score, const std::map<std::string, double>& answers);

}  // namespace ocelli
