// The catalogues of fixed texts: each has what English has, no more and no less.
#include "study/outline/subject_texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/outline/built_in_files.h"
#include "study/outline/local_text.h"
#include "tests/study_outline/outline_text.h"

namespace ocelli::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(SubjectTexts, EveryLanguageHasAllTextsAndPlaceholders) {
  const SubjectCatalogue& english = subjectCatalogues().front();
  ASSERT_EQ(english.language, kSourceLanguage);
  EXPECT_FALSE(english.isDraft);
  EXPECT_GT(english.texts.size(), 60u);
  for (const SubjectCatalogue& each : subjectCatalogues()) {
    for (const auto& [id, text] : english.texts) {
      ASSERT_TRUE(each.texts.contains(id)) << each.language << " lacks " << id;
      EXPECT_EQ(placeholdersOf(each.texts.at(id)), placeholdersOf(text)) << each.language << ": " << id;
    }
    for (const auto& [id, text] : each.texts) {
      EXPECT_TRUE(english.texts.contains(id)) << each.language << " has the unknown " << id;
    }
  }
}

TEST(SubjectTexts, FilesAreNamedAfterTheirLanguage) {
  for (const BuiltInFile& file : builtInLanguages()) {
    const SubjectCatalogue catalogue = subjectCatalogueFromJsonText(file.text, file.name);
    EXPECT_EQ(file.name, "protocols/languages/" + catalogue.language + ".json");
  }
  EXPECT_TRUE(SubjectTexts("ar").rightToLeft());
  EXPECT_FALSE(SubjectTexts("ja").rightToLeft());
}

TEST(SubjectTexts, PlaceholdersAreFilledIn) {
  EXPECT_EQ(SubjectTexts().say("trial", {{"number", "3"}, {"total", "12"}}), "Trial 3 of 12");
  EXPECT_EQ(SubjectTexts("de").say("trial", {{"number", "3"}, {"total", "12"}}), "Durchgang 3 von 12");
  EXPECT_EQ(SubjectTexts("de").say("trial", {{"number", "{total}"}, {"total", "{number}"}}).find("{}"),
            std::string::npos);
  EXPECT_THAT(placeholdersOf("{b} of {a}, {b}"), ElementsAre("a", "b", "b"));
}

TEST(SubjectTexts, TranslatesWhatItKnows) {
  EXPECT_EQ(SubjectTexts("fr").translated("Count the objects"), "Comptez les objets");
  EXPECT_EQ(SubjectTexts("fr").translated("Fly to the moon"), "Fly to the moon") << "of a task of another program";
  EXPECT_EQ(SubjectTexts("de").keyName("Enter"), "Eingabe");
  EXPECT_EQ(SubjectTexts("de").keyName("F10"), "F10");
}

TEST(LocalTexts, AreThoseOfTheLanguageOrEnglish) {
  const auto read = [](const std::string& language) {
    return [language](JsonFields& fields, ProtocolReading) { return localText(fields, "t", 10, language); };
  };
  const std::string both = R"({"t": {"en": "Go", "de": "Los"}})";
  EXPECT_EQ(readOutline(both, ProtocolReading::kByStudy, read("de")), "Los");
  EXPECT_EQ(readOutline(both, ProtocolReading::kByStudy, read("ja")), "Go");
  EXPECT_EQ(readOutline(R"({"t": "Go"})", ProtocolReading::kByStudy, read("de")), "Go");
  const auto errorOf = [&](const char* json) { return outlineErrorOf(json, ProtocolReading::kByStudy, read("de")); };
  EXPECT_THAT(errorOf(R"({"t": {"fr": "Allez"}})"), HasSubstr("has no text in \"de\", and none in \"en\""));
  EXPECT_THAT(errorOf(R"({"t": {"xx": "?"}})"), HasSubstr("names the language \"xx\""));
  EXPECT_THAT(errorOf(R"({"t": {"en": ""}})"), HasSubstr("1 to 10 characters"));
  EXPECT_THAT(errorOf(R"({"t": {"en": "12345678901"}})"), HasSubstr("1 to 10 characters"));
  EXPECT_THAT(errorOf("{}"), HasSubstr("\"t\""));
}

}  // namespace
}  // namespace ocelli::test
