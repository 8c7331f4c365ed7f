#include "oc_core/page/html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(Html, digitsAreGroupedInThrees) {
  EXPECT_EQ(groupedDigits(0), "0");
  EXPECT_EQ(groupedDigits(999), "999");
  EXPECT_EQ(groupedDigits(1000), "1\u202f000");
  EXPECT_EQ(groupedDigits(1234567), "1\u202f234\u202f567");
}

TEST(Html, textIsNoMarkup) {
  EXPECT_EQ(htmlFromText("<b>\"a\" & b</b>"), "&lt;b&gt;&quot;a&quot; &amp; b&lt;/b&gt;");
  EXPECT_EQ(htmlFromText("<script>'a\xFF'"), "&lt;script&gt;&#39;a\uFFFD&#39;") << "invalid bytes are replaced";
  EXPECT_EQ(htmlFromText(""), "");
}

TEST(Html, pageHasItsTitleAndStyles) {
  const std::string page = pageBegin("One & two", {"p { color: red; }", "b { color: blue; }"}) + pageEnd();
  EXPECT_THAT(page, testing::StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(page, testing::HasSubstr("<title>One &amp; two</title>"));
  EXPECT_LT(page.find("--ground"), page.find("p { color: red; }")) << "the shared style comes first";
  EXPECT_LT(page.find("p { color: red; }"), page.find("b { color: blue; }"));
  EXPECT_THAT(page, testing::EndsWith("</body>\n</html>\n"));
}

}  // namespace
}  // namespace ocelli
