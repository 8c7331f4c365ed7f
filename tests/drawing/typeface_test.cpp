#include "oc_core/drawing/typeface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(Typeface, widthsAddUpAndGrowWithTheSize) {
  const double width = textWidth("Time to find", Face::kSans, 8);
  EXPECT_GT(width, 30);
  EXPECT_LT(width, 70);
  EXPECT_NEAR(textWidth("Time to find", Face::kSans, 16), 2 * width, 1e-9);
  EXPECT_NEAR(textWidth("Time", Face::kSans, 8) + textWidth(" to find", Face::kSans, 8), width, 1e-9);
  EXPECT_GT(textWidth("Time to find", Face::kSansBold, 8), width);
}

TEST(Typeface, linesFitAndKeepAllWords) {
  const std::string text = "The observers found every object, one after the other, in less than a minute";
  const std::vector<std::string> lines = brokenLines(text, Face::kSerif, 10, 120);
  ASSERT_GT(lines.size(), 2U);
  std::string joined;
  for (const std::string& line : lines) {
    EXPECT_LE(textWidth(line, Face::kSerif, 10), 120);
    joined += (joined.empty() ? "" : " ") + line;
  }
  EXPECT_EQ(joined, text);
  // Greedy: the first word of a line had no room on the line before.
  for (size_t i = 1; i < lines.size(); ++i) {
    const std::string first = lines[i].substr(0, lines[i].find(' '));
    EXPECT_GT(textWidth(lines[i - 1] + " " + first, Face::kSerif, 10), 120);
  }
}

TEST(Typeface, longWordsAreBrokenAndNewlinesKept) {
  for (const std::string& line : brokenLines(std::string(200, 'x'), Face::kMono, 10, 100)) {
    EXPECT_LE(textWidth(line, Face::kMono, 10), 100);
  }
  EXPECT_THAT(brokenLines("a\n\nb", Face::kSans, 8, 100), testing::ElementsAre("a", "", "b"));
  EXPECT_THAT(brokenLines("", Face::kSans, 8, 100), testing::ElementsAre(""));
}

TEST(Typeface, shortenedTextFits) {
  const std::string text = shortened("a rather long label of an axis", Face::kSans, 8, 50);
  EXPECT_LE(textWidth(text, Face::kSans, 8), 50);
  EXPECT_THAT(text, testing::EndsWith("\u2026"));
  EXPECT_EQ(shortened("short", Face::kSans, 8, 50), "short");
}

}  // namespace
}  // namespace ocelli
