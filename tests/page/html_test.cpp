#include "oc_core/page/html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(Html, TellsTheFigures) {
  const std::string page = demoPage({scene("a")}, {}, "0.1");
  EXPECT_THAT(page, HasSubstr("10.00 %"));  // 100 of 1000
  EXPECT_THAT(page, HasSubstr("2.50 %"));
  EXPECT_THAT(page, HasSubstr("25.0 %"));  // of the depth image's
  EXPECT_THAT(page, HasSubstr(groupedDigits(1234567)));
  EXPECT_THAT(page, HasSubstr("<td>37.50 %</td><td>20.0 dB</td>"));  // 3 of 8, 0.01
}

TEST(Html, textIsNoMarkup) {
  EXPECT_EQ(htmlFromText("<b>\"a\" & b</b>"), "&lt;b&gt;&quot;a&quot; &amp; b&lt;/b&gt;");
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
