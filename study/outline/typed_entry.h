// What kinds of questions share that are typed.
#pragma once

#include "study/outline/question_kinds.h"

namespace ocelli {

void appendUtf8(std::string& text, char32_t character);
size_t countUtf8(const std::string& text);
/// Takes the last character away.
void dropLastUtf8(std::string& text);

/// Backspace.
void pressTyped(const FormField& field, QuestionEntry& entry, Key key);
/// The character that comes next on the way to what the target has typed, or Backspace where the entry has others.
std::optional<QuestionStroke> strokeTowardsTyped(const FormField& field, const QuestionEntry& entry,
                                                 const QuestionEntry& target);

}  // namespace ocelli
