#include "study/outline/subject_texts.h"

#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/check.h"
#include "oc_core/base/json_fields.h"
#include "study/outline/built_in_files.h"
#include "study/outline/protocol_reading.h"

namespace ocelli {
namespace {

constexpr size_t kMaxTexts = 500;

const SubjectCatalogue* catalogueOf(const std::string& language) {
  const std::vector<SubjectCatalogue>& all = subjectCatalogues();
  const auto found = std::ranges::find(all, language, &SubjectCatalogue::language);
  return found == all.end() ? nullptr : &*found;
}

void replaceAll(std::string& text, const std::string& what, const std::string& by) {
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

}  // namespace

SubjectCatalogue subjectCatalogueFromJsonText(const std::string& text, const std::string& where) {
  const JsonDocument document(text, where);
  JsonFields fields(document);
  SubjectCatalogue catalogue;
  catalogue.language = fields.shortText("language", kMaxTitleCharacters);
  catalogue.name = fields.shortText("name", kMaxTitleCharacters);
  catalogue.rightToLeft = fields.boolean("right_to_left", false);
  catalogue.isDraft = fields.boolean("draft", false);
  catalogue.letters = fields.shortText("letters", kMaxParagraphCharacters, "");
  JsonFields texts = fields.inner("texts");
  const nlohmann::json& object = fields.value("texts");
  if (object.size() > kMaxTexts) {
    fields.fail("texts", fmt::format("must have at most {} texts", kMaxTexts));
  }
  for (const auto& [id, unused] : object.items()) {
    catalogue.texts[id] = texts.shortText(id, kMaxParagraphCharacters);
  }
  texts.rejectUnknown();
  fields.rejectUnknown();
  return catalogue;
}

const std::vector<SubjectCatalogue>& subjectCatalogues() {
  static const std::vector<SubjectCatalogue> all = [] {
    std::vector<SubjectCatalogue> read;
    for (const BuiltInFile& file : builtInLanguages()) {
      read.push_back(subjectCatalogueFromJsonText(file.text, file.name));
    }
    return read;
  }();
  return all;
}

std::string languageCodes() {
  std::string codes;
  for (const SubjectCatalogue& each : subjectCatalogues()) {
    codes += (codes.empty() ? "" : ", ") + each.language;
  }
  return codes;
}

bool isLanguage(const std::string& code) {
  return catalogueOf(code) != nullptr;
}

std::vector<std::string> placeholdersOf(const std::string& text) {
  std::vector<std::string> names;
  for (size_t open = text.find('{'); open != std::string::npos; open = text.find('{', open + 1)) {
    const size_t close = text.find('}', open);
    if (close == std::string::npos) {
      break;
    }
    names.push_back(text.substr(open + 1, close - open - 1));
  }
  std::ranges::sort(names);
  return names;
}

SubjectTexts::SubjectTexts() : SubjectTexts(kSourceLanguage) {}

SubjectTexts::SubjectTexts(const std::string& language) : catalogue_(catalogueOf(language)) {
  OC_CHECK(catalogue_ != nullptr, "a language that there is a catalogue of");
}

std::string SubjectTexts::say(std::string_view id, std::initializer_list<TextArgument> arguments) const {
  const auto found = catalogue_->texts.find(std::string(id));
  OC_CHECK(found != catalogue_->texts.end(), "an id that the catalogues have");
  std::string text = found->second;
  for (const TextArgument& argument : arguments) {
    replaceAll(text, fmt::format("{{{}}}", argument.name), argument.value);
  }
  return text;
}

std::string SubjectTexts::translated(const std::string& english) const {
  if (catalogue_->language == kSourceLanguage) {
    return english;
  }
  for (const auto& [id, text] : catalogueOf(kSourceLanguage)->texts) {
    if (text == english) {
      return say(id);
    }
  }
  return english;
}

std::string SubjectTexts::keyName(std::string_view key) const {
  const auto found = catalogue_->texts.find(fmt::format("key_{}", key));
  return found == catalogue_->texts.end() ? std::string(key) : found->second;
}

}  // namespace ocelli
