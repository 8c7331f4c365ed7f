#include "study/screen/drawable_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/study_screen/font_folder.h"

namespace ocelli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(DrawableText, readsCharactersOfUtf8) {
  EXPECT_EQ(charactersOf("a\u00e9\u4f60\U0001f600"), U"a\u00e9\u4f60\U0001f600");
  EXPECT_EQ(charactersOf("a\xff\xe4\xbd"), U"a\ufffd\ufffd");  // a wrong byte, and a character that is cut off
  EXPECT_EQ(utf8Of(U"a\u00e9\u4f60\U0001f600"), "a\u00e9\u4f60\U0001f600");
  EXPECT_THAT(glyphsOf("ba\nb\ta"), ElementsAre(U'a', U'b'));
}

TEST(DrawableText, knowsTheScriptsThatItCannotWrite) {
  for (const char32_t plain : std::u32string(U"aé ßЖΩ你かハ한、。！→≤“–…سא\ufeed")) {
    EXPECT_EQ(scriptProblem(plain), std::nullopt) << static_cast<uint32_t>(plain);
  }
  const std::pair<char32_t, const char*> cases[] = {
      {U'\u0710', "joined"},  {U'\u064e', "NFC"},     {U'\u05b0', "NFC"},         {U'\u0915', "joined"},
      {U'\u0e01', "joined"},  {U'\u1100', "joined"},  {U'\u0301', "NFC"},         {U'\u200f', "control"},
      {U'\ufe0f', "control"}, {U'\u0007', "control"}, {U'\ue000', "not defined"}, {U'\U0001f600', "above U+FFFF"}};
  for (const auto& [character, reason] : cases) {
    EXPECT_THAT(scriptProblem(character).value_or(""), HasSubstr(reason)) << static_cast<uint32_t>(character);
  }
}

TEST(DrawableText, asksTheFontsThatAreInstalled) {
  const std::set<char32_t> texts = glyphsOf("Hello, Ωμέγα, 你好, かな");
  EXPECT_THAT(undrawableOf(texts), IsEmpty()) << "install fonts-droid-fallback";
  const test::FontsOf europe(test::ownFontFolder());
  const auto undrawable = undrawableOf(texts);
  ASSERT_EQ(undrawable.size(), 1U);
  EXPECT_EQ(undrawable[0].characters, U"かな你好");
  EXPECT_THAT(undrawable[0].reason, HasSubstr("no font"));
}

TEST(DrawableText, withoutAnyFontLatinLettersAreLeft) {
  const test::FontsOf none("");
  EXPECT_THAT(undrawableOf(glyphsOf("plain, é")), IsEmpty());
  const auto undrawable = undrawableOf(glyphsOf("aЖ"));
  ASSERT_EQ(undrawable.size(), 1U);
  EXPECT_EQ(undrawable[0].characters, U"Ж");
}

TEST(DrawableText, namesCharactersByCodePoint) {
  EXPECT_EQ(namesOf(U"你\u0301"), "U+4F60 你, U+0301");
  EXPECT_EQ(namesOf(U"\U0001f600"), "U+1F600 \U0001f600");
  EXPECT_THAT(namesOf(std::u32string(30, U'x')), testing::EndsWith(" and 18 more"));
}

}  // namespace
}  // namespace ocelli
