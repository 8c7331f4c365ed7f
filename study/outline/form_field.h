// A question of a form: an object in the field "fields" of a form of a protocol, or of a questionnaire.
#pragma once

#include <string>
#include <vector>

#include "study/outline/protocol_reading.h"
#include "study/outline/subject_texts.h"
#include "study/trial/view_condition.h"

namespace ocelli {

class JsonFields;

/// Of a matrix: the same options are offered for each.
struct QuestionRow {
  std::string name;  ///< its answer is named "FIELD_NAME"
  std::string label;
};

struct FormField {
  std::string name;  ///< of the answer in the database: "age_band"
  std::string question;
  std::vector<std::string> options{};  ///< of kinds with options; in a study always at least two
  std::vector<std::string> ends{};     ///< of a scale: what its first and last option mean; empty, or two
  std::vector<TrialView> favors{};     ///< of a scale that compares two conditions: which one its first and its last
                                       ///< option speak for; empty, or two
  std::string kind = "choice";         ///< a row of study/outline/question_kinds.h
  std::vector<std::string> values{};   ///< stored in place of the options; empty, or as many
  bool required = true;                ///< the form waits for an answer
  std::vector<QuestionRow> rows{};     ///< of a matrix
  double least = 0;                    ///< of numbers and sliders
  double most = 100;
  double step = 1;     ///< of a slider, from one place of the mark to the next; of a number, what it is a multiple of
  std::string unit{};  ///< that stands beside a number
  int maxCharacters = 500;  ///< of a text
};

/// An analysis takes a field without a question, which is then its name, and one without options, which takes any text.
/// Texts are those of the language, or English. Throws InputError naming the field.
FormField readFormField(JsonFields& fields, const ViewConditions& conditions, ProtocolReading reading,
                        const std::string& language = kSourceLanguage);

/// "age_band": what names columns of tables is of small letters, digits and _, and begins with a letter.
std::string readColumnName(JsonFields& fields, const std::string& name, ProtocolReading reading);

}  // namespace ocelli
