#include "study/screen/text_wrapping.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace ocelli {
namespace {

using testing::ElementsAre;

/// Every character is 1 wide.
std::vector<std::u32string> wrapped(std::u32string_view text, double width) {
  std::vector<std::u32string> lines;
  for (const auto& [from, to] : wrapLines(text, width, [](char32_t) { return 1.0; })) {
    lines.emplace_back(text.substr(from, to - from));
  }
  return lines;
}

TEST(TextWrapping, breaksAtSpaces) {
  EXPECT_THAT(wrapped(U"one two three", 8), ElementsAre(U"one two", U"three"));
  EXPECT_THAT(wrapped(U"one two three", 7), ElementsAre(U"one two", U"three")) << "a space at the end takes no room";
  EXPECT_THAT(wrapped(U"one two three", 100), ElementsAre(U"one two three"));
  EXPECT_THAT(wrapped(U"", 5), ElementsAre());
}

TEST(TextWrapping, keepsNewlines) {
  EXPECT_THAT(wrapped(U"a\n\nb", 5), ElementsAre(U"a", U"", U"b"));
}

TEST(TextWrapping, cutsWordsThatAreTooLong) {
  EXPECT_THAT(wrapped(U"abcdefg hi", 3), ElementsAre(U"abc", U"def", U"g", U"hi"));
  EXPECT_THAT(wrapped(U"ab", 0.5), ElementsAre(U"a", U"b"));
}

TEST(TextWrapping, breaksBetweenIdeographs) {
  EXPECT_THAT(wrapped(U"物体を数えて", 4), ElementsAre(U"物体を数", U"えて"));
  EXPECT_THAT(wrapped(U"F10 を押す", 5), ElementsAre(U"F10 を", U"押す"));
}

TEST(TextWrapping, signsStandWhereTheyMayStand) {
  EXPECT_THAT(wrapped(U"数えて。次へ", 3), ElementsAre(U"数え", U"て。次", U"へ")) << "no stop begins a line";
  EXPECT_THAT(wrapped(U"次は「物体」", 3), ElementsAre(U"次は", U"「物", U"体」")) << "no opening bracket ends one";
  EXPECT_THAT(wrapped(U"データを", 2), ElementsAre(U"デー", U"タを")) << "a long vowel stays with its letter";
}

}  // namespace
}  // namespace ocelli
