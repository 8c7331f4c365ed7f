#include "oc_core/base/utf8.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(Utf8, whatIsNoTextIsReplaced) {
  const std::string replaced = "\uFFFD";
  EXPECT_EQ(cleanText("a\xFF"), "a" + replaced);
  EXPECT_EQ(cleanText(std::string_view("\0x", 2)), replaced + "x");
  EXPECT_EQ(cleanText("\xC0\xAF"), replaced + replaced) << "an overlong slash";
  EXPECT_EQ(cleanText("\xE2\x82"), replaced + replaced) << "cut off";
  EXPECT_EQ(cleanText("\xED\xA0\x80"), replaced) << "half of a pair";
  EXPECT_EQ(cleanText("\x1b[31m"), replaced + "[31m");
  EXPECT_EQ(cleanText("Übung \u2264 \U0001F600\n"), "Übung \u2264 \U0001F600\n");
}

TEST(CharacterCount, countsCharactersAndNotBytes) {
  EXPECT_EQ(characterCount(""), 0u);
  EXPECT_EQ(characterCount("a\u00e9\u2615\U0001F600"), 4u);
}

}  // namespace
}  // namespace ocelli
