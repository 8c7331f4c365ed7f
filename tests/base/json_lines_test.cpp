#include "oc_core/base/json_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ocelli::test {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(JsonLines, AreThoseOfNamesAndElements) {
  EXPECT_THAT(
      linesOfJson("{\n\"a\":\n[1,\n{\"b\": \"x\\\"}\"}],\n\n\"c\": null}"),
      ElementsAre(Pair("", 1), Pair("/a", 2), Pair("/a/0", 3), Pair("/a/1", 4), Pair("/a/1/b", 4), Pair("/c", 6)));
  EXPECT_THAT(linesOfJson("\n7"), ElementsAre(Pair("", 2)));
  EXPECT_THAT(linesOfJson("\xef\xbb\xbf\n[]"), ElementsAre(Pair("", 2))) << "after a byte order mark";
}

TEST(JsonLines, CountThroughComments) {
  EXPECT_THAT(linesOfJson("// one {\n{/* two\n\"no\": */ \"a\": 1 // three, \"no\": 2\n, \"b\": 2}// end"),
              ElementsAre(Pair("", 2), Pair("/a", 3), Pair("/b", 4)));
  // As the parser: a comment ends with a carriage return, or with a byte of 0.
  EXPECT_THAT(linesOfJson(std::string("{// one\r\"a\": 1, /* two\n */ // three\0\n\"b\": 1}", 44)),
              ElementsAre(Pair("", 1), Pair("/a", 1), Pair("/b", 3)));
}

TEST(JsonLines, PointersEscapeNames) {
  EXPECT_EQ(pointerToField("", "a"), "/a");
  EXPECT_EQ(pointerToField("/a", "b/c~d"), "/a/b~1c~0d");
  EXPECT_EQ(pointerToElement("/a", 12), "/a/12");
  EXPECT_THAT(linesOfJson("{\"a/b\":\n{\"~\": 1, \"\\u0041\": 2}}"),
              ElementsAre(Pair("", 1), Pair("/a~1b", 1), Pair("/a~1b/A", 2), Pair("/a~1b/~0", 2)));
}

TEST(JsonLines, TellTheBytesOfAValue) {
  const std::string text = "{\"a\": [1, {\"b\": /* { */ {\"c\": \"}\"} }], \"d\": -1.5e3\n}";
  const auto valueAt = [&](const std::string& pointer) {
    const auto [begin, end] = bytesOfJson(text, pointer);
    return text.substr(begin, end - begin);
  };
  EXPECT_EQ(valueAt("/a/1/b"), "{\"c\": \"}\"}");
  EXPECT_EQ(valueAt("/a/0"), "1");
  EXPECT_EQ(valueAt("/d"), "-1.5e3");
  EXPECT_EQ(valueAt(""), text);
  EXPECT_EQ(bytesOfJson(text, "/none"), std::pair(size_t{0}, size_t{0}));
}

}  // namespace
}  // namespace ocelli::test
