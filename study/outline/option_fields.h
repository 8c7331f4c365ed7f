// What kinds of questions with options share.
#pragma once

#include <optional>

#include "study/outline/question_kinds.h"

namespace ocelli {

/// The fields "options" and "values".
void readOptions(JsonFields& fields, FormField& field, ProtocolReading reading, const std::string& language);
/// The field "ends", empty where it is missing.
void readEnds(JsonFields& fields, FormField& field, ProtocolReading reading, const std::string& language);

/// The option that a digit stands for, from 0; nothing for other keys and for options that there are not.
std::optional<int> optionOfDigit(const FormField& field, Key key);

// One option of a list: by the digits, and by the arrows from one to the next.
void pressOption(const FormField& field, QuestionEntry& entry, Key key);
void clickOption(const FormField& field, QuestionEntry& entry, const QuestionClick& click);
std::optional<std::string> storedOption(const FormField& field, const QuestionEntry& entry);
QuestionLook lookOfOption(const FormField& field, const QuestionEntry& entry);
QuestionEntry randomOption(const FormField& field, Random& random);
std::optional<QuestionStroke> strokeTowardsOption(const FormField& field, const QuestionEntry& entry,
                                                  const QuestionEntry& target);

// For rows of kinds that have nothing to say there.
void typeNothing(const FormField& field, QuestionEntry& entry, char32_t character);
void clickNothing(const FormField& field, QuestionEntry& entry, const QuestionClick& click);
std::optional<QuestionProblem> noProblem(const FormField& field, const QuestionEntry& entry);

}  // namespace ocelli
