// The fixed texts that a subject reads: buttons, hints, breaks, what forms find wrong, prompts of tasks. They come from
// catalogues, a file a language: protocols/languages/LANGUAGE.json, which are built into the program. English is the
// source: it has all texts, and the others must have the same ones with the same placeholders ("{total}").
//
// Recipe for a further language: protocols/languages/NAME.json with all texts of en.json, and its name in
// study/outline/CMakeLists.txt. tests/study_outline/subject_texts_test.cpp then checks it. It says "draft": true until
// someone whose first language it is has read it.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

inline constexpr const char* kSourceLanguage = "en";

struct SubjectCatalogue {
  std::string language;      ///< "de"
  std::string name;          ///< in the language itself: "Deutsch"
  bool rightToLeft = false;  ///< so is the screen laid out
  bool isDraft = false;      ///< nobody whose first language it is has read it yet
  std::string letters;       ///< that subjects may type besides those of Europe, so that the screens have them
  std::map<std::string, std::string> texts;  ///< by id
};

/// Throws InputError naming `where` and the field.
SubjectCatalogue subjectCatalogueFromJsonText(const std::string& text, const std::string& where);
/// Of all languages, English first. They live until the program ends.
const std::vector<SubjectCatalogue>& subjectCatalogues();
/// "en, de, ...".
std::string languageCodes();
bool isLanguage(const std::string& code);
/// The names of placeholders, each as often as it stands there, in order of the alphabet.
std::vector<std::string> placeholdersOf(const std::string& text);

/// What stands in the place of "{name}".
struct TextArgument {
  std::string_view name;
  std::string value;
};

/// The texts of one language. Copies are cheap.
class SubjectTexts {
 public:
  SubjectTexts();  ///< English
  /// `language` must be one of languageCodes().
  explicit SubjectTexts(const std::string& language);

  const SubjectCatalogue& catalogue() const { return *catalogue_; }
  bool rightToLeft() const { return catalogue_->rightToLeft; }
  /// The text of an id that en.json has.
  std::string say(std::string_view id, std::initializer_list<TextArgument> arguments = {}) const;
  /// The text whose English is `english`; `english` itself where the catalogue has none, as of tasks of other programs.
  std::string translated(const std::string& english) const;
  /// What is written on a key that nameOf(Key) calls so; the name itself where the catalogue has none.
  std::string keyName(std::string_view key) const;

 private:
  const SubjectCatalogue* catalogue_;
};

}  // namespace ocelli
