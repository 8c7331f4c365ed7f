#include "study/screen/bidi_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/screen/drawable_text.h"

namespace ocelli {
namespace {

std::u32string shown(const std::string& text, bool rightToLeft) {
  const BidiParagraph paragraph(text, rightToLeft);
  return paragraph.visual(0, paragraph.characters().size());
}

TEST(BidiText, leavesWhatIsWrittenFromTheLeft) {
  EXPECT_EQ(shown("Trial 3 of 12, na\u00efve \u4f60", false), U"Trial 3 of 12, na\u00efve \u4f60");
  EXPECT_EQ(shown("", true), U"");
  EXPECT_EQ(shown("", false), U"");
}

TEST(BidiText, hebrewIsTurnedAndNotJoined) {
  EXPECT_EQ(shown("\u05d0\u05d1\u05d2", true), U"\u05d2\u05d1\u05d0");
}

/// Beh alone, and at the beginning, in the middle and at the end of a word (Unicode 15, block FE70-FEFF).
TEST(BidiText, arabicLettersHaveTheFormOfTheirPlace) {
  EXPECT_EQ(shown("\u0628", true), U"\ufe8f");
  EXPECT_EQ(shown("\u0628\u0628\u0628", true), U"\ufe90\ufe92\ufe91") << "the last letter stands at the left";
  // Alef joins to the letter before it alone: what follows begins anew.
  EXPECT_EQ(shown("\u0628\u0627\u0628", true), U"\ufe8f\ufe8e\ufe91");
}

TEST(BidiText, lamAndAlefAreOneLetter) {
  EXPECT_EQ(shown("\u0644\u0627", true), U"\ufefb");
  EXPECT_EQ(shown("\u0628\u0644\u0627", true), U"\ufefc\ufe91");
}

TEST(BidiText, numbersAndWordsWithinKeepTheirDirection) {
  // "beh beh 12 / F10 beh": the numbers are read from the left.
  EXPECT_EQ(shown("\u05d0 12 \u05d1", true), U"\u05d1 12 \u05d0");
  EXPECT_EQ(shown("\u05d0 F10 \u05d1", true), U"\u05d1 F10 \u05d0");
  EXPECT_EQ(shown("a \u05d0\u05d1 b", false), U"a \u05d1\u05d0 b") << "and in a text from the left";
}

TEST(BidiText, aParagraphRunsAsMostOfItsLettersDo) {
  EXPECT_EQ(shown("Which \u05d0?", true), U"Which \u05d0?") << "an English text on an Arabic screen";
  EXPECT_EQ(shown("\u05d0 x?", false), U"?x \u05d0") << "and the other way round";
  EXPECT_EQ(shown("F1 \u05d0\u05d1.", true), U".\u05d1\u05d0 F1") << "a key first in a text from the right";
  EXPECT_EQ(shown("12?", true), U"?12") << "without letters as the language does";
}

TEST(BidiText, bracketsAreMirrored) {
  EXPECT_EQ(shown("(\u05d0)", true), U"(\u05d0)");
  EXPECT_EQ(shown("\u05d0 (\u05d1", true), U"\u05d1) \u05d0");
}

/// A paragraph is cut in the order of reading: its first words stand on the first line.
TEST(BidiText, linesAreTurnedOneByOne) {
  const BidiParagraph paragraph("\u05d0\u05d1 \u05d2\u05d3 \u05d4\u05d5", true);
  EXPECT_EQ(paragraph.visual(0, 5), U"\u05d3\u05d2 \u05d1\u05d0");
  EXPECT_EQ(paragraph.visual(6, 8), U"\u05d5\u05d4");
  EXPECT_EQ(paragraph.visual(3, 3), U"");
}

TEST(BidiText, alphabetsHaveTheFormsOfAllWords) {
  const std::string letters = "\u0628\u0627\u0644\u062f\u0633\u0645";
  const std::set<char32_t> known = shapedAlphabet(letters);
  for (const char* word : {"\u0633\u0644\u0627\u0645", "\u0628\u0627\u0628", "\u0628\u0644\u0627\u062f",
                           "\u0645\u0627\u062f\u0627\u0645", "\u0644\u0627 \u0633\u0628\u0628"}) {
    for (const char32_t glyph : shapedGlyphsOf(word)) {
      EXPECT_TRUE(glyph == U' ' || known.contains(glyph)) << word << ": " << namesOf(std::u32string(1, glyph));
    }
  }
}

}  // namespace
}  // namespace ocelli
