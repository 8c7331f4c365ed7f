#include "display_driver/demo/demo_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "oc_core/page/html.h"
#include "tests/page/unstyled_classes.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::Not;

RepresentationFigures figures(const std::string& name, size_t strict) {
  RepresentationFigures row;
  row.name = name;
  row.edges.truth = 1000;
  row.edges.strict = strict;
  row.edges.thick = strict / 2;
  row.strictRatioToDi = static_cast<double>(strict) / 100;
  return row;
}

DemoScene scene(const std::string& title) {
  const std::vector<DemoImage> images{{"a/1.png", "Depth image", "one", 4, 3}, {"a/2.png", "OCRI", "two", 4, 3}};
  return {title,
          "builtin:room",
          {{"Row one", "text", images}, {"Row two", "", images}},
          1234567,
          8,
          {figures("di", 100), figures("ddoc", 25)},
          {"in front"},
          {{"Full geometry", 12, 34, 1, {{.eyes = 1, .light = 8, .hiddenLight = 3, .squaredError = 0.01}}}}};
}

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), regex); it != std::sregex_iterator(); ++it) {
    found.push_back((*it)[1]);
  }
  return found;
}

TEST(DemoPage, EscapesWhatTheUserNamed) {
  const std::string page = demoPage({scene("<b>\"rabbit\" & co</b>")}, {}, "0.1");
  EXPECT_THAT(page, HasSubstr("&lt;b&gt;&quot;rabbit&quot; &amp; co&lt;/b&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<b>\"rabbit\"")));
}

TEST(DemoPage, StyleHasItsClassesAndColours) {
  const std::string page = demoPage({scene("a")}, {}, "0.1");
  EXPECT_THAT(test::unstyledClasses(page), testing::IsEmpty());
  EXPECT_THAT(test::undefinedProperties(page), testing::IsEmpty());
}

TEST(DemoPage, NeedsNothingFromElsewhere) {
  const std::string page = demoPage({scene("a"), scene("b")}, {}, "0.1");
  EXPECT_THAT(page, Not(HasSubstr("://")));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("src=\"/")));
}

TEST(DemoPage, EveryImageSaysWhatItShows) {
  const std::string page = demoPage({scene("A teapot")}, {}, "0.1");
  const std::vector<std::string> tags = matches(page, "(<img[^>]*>)");
  ASSERT_EQ(tags.size(), 8u);  // two rows of two, side by side and in one place
  for (const std::string& tag : tags) {
    EXPECT_TRUE(std::regex_search(tag, std::regex("alt=\"A teapot, Row (one|two): (Depth image|OCRI)\""))) << tag;
  }
}

TEST(DemoPage, IdsAreUniqueAndEveryLabelHasItsInput) {
  const std::string page = demoPage({scene("a"), scene("b")}, {}, "0.1");
  const std::vector<std::string> ids = matches(page, " id=\"([^\"]*)\"");
  const std::set<std::string> unique(ids.begin(), ids.end());
  EXPECT_EQ(unique.size(), ids.size());
  for (const std::string& wanted : matches(page, "(?:for=\"|href=\"#|labelledby=\")([^\"]*)\"")) {
    EXPECT_TRUE(unique.contains(wanted)) << wanted;
  }
}

TEST(DemoPage, OpenedTagsAreClosed) {
  const std::string page = demoPage({scene("a")}, {}, "0.1");
  for (const char* tag : {"html", "body", "main", "section", "div", "figure", "table", "tr", "td", "th", "fieldset",
                          "details", "p", "h2", "h3", "label"}) {
    const std::string name(tag);
    EXPECT_EQ(matches(page, "(<" + name + "[ >])").size(), matches(page, "(</" + name + ">)").size()) << tag;
  }
}

TEST(DemoPage, TellsTheFigures) {
  const std::string page = demoPage({scene("a")}, {}, "0.1");
  EXPECT_THAT(page, HasSubstr("10.00 %"));  // 100 of 1000
  EXPECT_THAT(page, HasSubstr("2.50 %"));
  EXPECT_THAT(page, HasSubstr("25.0 %"));  // of the depth image's
  EXPECT_THAT(page, HasSubstr(groupedDigits(1234567)));
  EXPECT_THAT(page, HasSubstr("<td>37.50 %</td><td>20.0 dB</td>"));  // 3 of 8, 0.01
}

}  // namespace
}  // namespace ocelli
