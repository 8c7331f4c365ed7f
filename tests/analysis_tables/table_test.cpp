#include "analysis/tables/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/tables/table_cells.h"

namespace ocelli::test {
namespace {

using ::testing::HasSubstr;

Trial trialOf(int64_t id, double seconds, bool timeOver, bool right = true) {
  Trial trial;
  trial.trialId = id;
  trial.responseSeconds = seconds;
  trial.censored = timeOver;
  trial.correct = right;
  return trial;
}

TEST(TableCells, meansSayOfHowMany) {
  const Trial a = trialOf(1, 10, false);
  const Trial b = trialOf(2, 13, false);
  const Trial c = trialOf(3, 60, true, false);
  const Cell removed = meanTimeCell("t/a", {&a, &b, &c}, TimeoutsInMeans::kRemoved);
  EXPECT_EQ(displayText(removed), "11.5 s (n = 2)");
  EXPECT_EQ(removed.rows, (std::vector<RowRef>{{0, 1}, {0, 2}}));
  EXPECT_THAT(removed.meaning, HasSubstr("1 more"));
  EXPECT_EQ(displayText(meanTimeCell("t/a", {&a, &b, &c}, TimeoutsInMeans::kSetToLimit)), "27.7 s (n = 3)");
  EXPECT_EQ(displayText(meanTimeCell("t/a", {&c}, TimeoutsInMeans::kRemoved)), "time ran out in all trials");
  EXPECT_EQ(displayText(meanTimeCell("t/a", {}, TimeoutsInMeans::kRemoved)), "no trials");
  EXPECT_EQ(displayText(rightShareCell("t/b", {&a, &b, &c})), "66.7 % (2/3)");
  EXPECT_EQ(displayText(timeoutShareCell("t/c", {&a, &b, &c})), "33.3 % (1/3)");
  EXPECT_EQ(displayText(rightShareCell("t/b", {})), "no trials");
  EXPECT_EQ(displayText(lessByCell("t/d", removed, rightShareCell("t/b", {}))), "not available");
  EXPECT_EQ(displayText(publishedCell("t/e", 12.9, "s", "")), "12.9 s");
  EXPECT_EQ(displayText(publishedCell("t/e", 0.00012, "", "")), "0.00012");
  EXPECT_EQ(displayText(publishedCell("t/e", std::nullopt, "s", "")), "not reported");
}

TEST(TableCells, errorsHaveASign) {
  Trial more = trialOf(1, 1, false);
  more.answer = "6";
  more.expected = "4";
  Trial fewer = trialOf(2, 1, false);
  fewer.answer = "3";
  fewer.expected = "4";
  Trial none = trialOf(3, 1, true);
  none.expected = "4";
  EXPECT_EQ(displayText(meanErrorCell("t/f", {&more, &fewer, &none})), "0.50 (n = 2)");
  EXPECT_EQ(displayText(meanErrorCell("t/f", {&none})), "no trials");
}

TEST(TableCells, publishedValuesKeepTheirDecimals) {
  EXPECT_EQ(displayText(publishedCell("t/e", 12.6, "s", "")), "12.6 s");
  EXPECT_EQ(displayText(publishedCell("t/e", 9.11, "s", "")), "9.11 s");
}

TEST(Table, isWrittenAsTextAndCsv) {
  const Trial a = trialOf(1, 10, false);
  Table table{"t", "A table", {"objects"}, {"ppc", "published"}, {}, {"A note."}};
  table.rows.push_back(
      {{"=x\n\xc3\xa9"}, {meanTimeCell("t/a", {&a}, TimeoutsInMeans::kRemoved), publishedCell("t/b", 9, "s", "m")}});
  EXPECT_EQ(plainText(table),
            "A table\n"
            "objects  ppc             published\n"
            "=x?\xc3\xa9     10.0 s (n = 1)  9.0 s\n"
            "  A note.\n");
  EXPECT_EQ(
      cellsCsv({table}),
      "table,cell,row,column,value,unit,numerator,denominator,published,missing,meaning\r\n"
      "t,t/a,\"'=x\n\xc3\xa9\",ppc,10,s,,1,0,,mean time of searches that ended in time; 0 more whose time ran out are "
      "left out\r\n"
      "t,t/b,\"'=x\n\xc3\xa9\",published,9,s,,,1,,m\r\n");
  EXPECT_EQ(findCell({table}, "t/b")->value, 9.0);
  EXPECT_EQ(findCell({table}, "t/c"), nullptr);
}

TEST(Table, namesArePlain) {
  EXPECT_EQ(namePart("Location 1"), "location-1");
  EXPECT_EQ(namePart("<b>a/b</b>"), "b-a-b-b");
  EXPECT_EQ(namePart("//"), "unnamed");
}

}  // namespace
}  // namespace ocelli::test
