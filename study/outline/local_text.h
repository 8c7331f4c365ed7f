// Texts of a protocol, which may be given in several languages: "Go", or {"en": "Go", "de": "Los"}.
#pragma once

#include <string>
#include <vector>

#include "study/outline/subject_texts.h"

namespace ocelli {

class JsonFields;

/// A text of 1 to so many characters in the language; in English where an object of languages lacks it. Throws
/// InputError naming the field, also where an object names no language that there is, or has neither.
std::string localText(JsonFields& fields, const std::string& name, size_t maxCharacters, const std::string& language);
std::string localText(JsonFields& fields, const std::string& name, size_t maxCharacters, const std::string& language,
                      const std::string& otherwise);
/// An array of `min` to `max` such texts. A missing field is an empty array.
std::vector<std::string> localTexts(JsonFields& fields, const std::string& name, size_t min, size_t max,
                                    size_t maxCharacters, const std::string& language);

/// The field "language"; English where it is missing.
std::string readLanguage(JsonFields& fields);

}  // namespace ocelli
