#include "study/outline/local_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

size_t characterCount(const std::string& utf8) {
  return static_cast<size_t>(
      std::ranges::count_if(utf8, [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80; }));
}

/// Of one text or an object of languages; `place` says which in messages.
std::string pickText(const JsonFields& fields, const std::string& name, const nlohmann::json& json,
                     const std::string& place, size_t maxCharacters, const std::string& language) {
  const auto checked = [&](const nlohmann::json& text) {
    const size_t count = text.is_string() ? characterCount(text.get_ref<const std::string&>()) : 0;
    if (count < 1 || count > maxCharacters) {
      fields.fail(name, fmt::format("{}must be a text of 1 to {} characters, or an object with one for each language",
                                    place, maxCharacters));
    }
    return text.get<std::string>();
  };
  if (!json.is_object()) {
    return checked(json);
  }
  for (const auto& [code, text] : json.items()) {
    if (!isLanguage(code)) {
      fields.fail(name,
                  fmt::format("{}names the language \"{}\", but must name some of {}", place, code, languageCodes()));
    }
    checked(text);
  }
  for (const std::string& code : {language, std::string(kSourceLanguage)}) {
    if (json.contains(code)) {
      return json.at(code).get<std::string>();
    }
  }
  fields.fail(name, fmt::format("{}has no text in \"{}\", and none in \"{}\"", place, language, kSourceLanguage));
}

}  // namespace

std::string localText(JsonFields& fields, const std::string& name, size_t maxCharacters, const std::string& language) {
  if (fields.has(name) && fields.value(name).is_object()) {
    return pickText(fields, name, fields.value(name), "", maxCharacters, language);
  }
  return fields.shortText(name, maxCharacters);
}

std::string localText(JsonFields& fields, const std::string& name, size_t maxCharacters, const std::string& language,
                      const std::string& otherwise) {
  return fields.has(name) ? localText(fields, name, maxCharacters, language) : otherwise;
}

std::vector<std::string> localTexts(JsonFields& fields, const std::string& name, size_t min, size_t max,
                                    size_t maxCharacters, const std::string& language) {
  const bool isLocal = fields.has(name) && fields.value(name).is_array() &&
                       std::ranges::any_of(fields.value(name), [](const auto& each) { return each.is_object(); });
  if (!isLocal) {
    return fields.texts(name, min, max, maxCharacters);
  }
  const nlohmann::json& list = fields.value(name);
  if (list.size() < min || list.size() > max) {
    fields.fail(name, fmt::format("must be an array of {} to {} texts", min, max));
  }
  std::vector<std::string> texts;
  for (const nlohmann::json& each : list) {
    texts.push_back(pickText(fields, name, each, fmt::format("{}: ", texts.size() + 1), maxCharacters, language));
  }
  return texts;
}

std::string readLanguage(JsonFields& fields) {
  std::string language = fields.text("language", kSourceLanguage);
  if (!isLanguage(language)) {
    fields.fail("language", fmt::format("must be one of: {}", languageCodes()));
  }
  return language;
}

}  // namespace ocelli
