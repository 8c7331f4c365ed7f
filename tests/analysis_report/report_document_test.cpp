#include "analysis/report/report_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/analysis_report/sample_document.h"

namespace ocelli {
namespace {

TEST(ReportDocument, tablesAndFiguresAreNumberedInOrder) {
  ReportDocument document;
  document.add(ReportHeading{1, "Finding & counting: the times"});
  document.add(ReportTable{});
  document.add(ReportFigure{});
  document.add(ReportTable{"", "stable-name", {}, {}});
  document.add(ReportParagraph{"text"});
  const std::vector<ElementName> names = elementNames(document);
  EXPECT_EQ(names[0].id, "finding-counting-the-times");
  EXPECT_EQ(names[1].label, "Table 1");
  EXPECT_EQ(names[2].label, "Figure 1");
  EXPECT_EQ(names[3].label, "Table 2");
  EXPECT_EQ(names[3].id, "stable-name");
  EXPECT_EQ(names[4].id, "");
}

TEST(ReportDocument, idsAreUniqueAndCellsKeepTheirs) {
  ReportDocument document;
  document.add(ReportHeading{1, "Times"});
  document.add(ReportHeading{1, "Times"});
  document.add(ReportTable{"", "", {{"a"}}, {{{"x", "times-2"}}}});
  document.add(ReportHeading{1, "\u03a9 7"});
  const std::vector<ElementName> names = elementNames(document);
  EXPECT_EQ(names[0].id, "times");
  EXPECT_EQ(names[1].id, "times-3");
  EXPECT_EQ(names[3].id, "s-7");
}

TEST(ReportDocument, cellsOfOneSourceAreListedTogether) {
  ReportTable table;
  table.columns = {{"Session"}, {"ppc", "Stationary"}, {"gc", "Stationary"}};
  table.rows = {{{"1"}, {"19.7", "c1", "rows 1 to 4"}, {"12.9", "c2", "rows 5 to 9"}},
                {{"2"}, {"15.7", "c3", "rows 1 to 4"}, {"10.9"}}};
  const std::vector<SourceEntry> entries = sourcesOf(table);
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].source, "rows 1 to 4");
  EXPECT_THAT(entries[0].cells, testing::ElementsAre("1, Stationary ppc", "2, Stationary ppc"));
  EXPECT_THAT(entries[0].ids, testing::ElementsAre("c1", "c3"));
}

TEST(ReportDocument, aRowWithOneSourceIsNamedAsOne) {
  ReportTable table;
  table.columns = {{"What"}, {"Estimate"}, {"p"}};
  table.rows = {{{"view"}, {"0.8", "view/estimate", "a model"}, {"0.02", "view/p", "a model"}},
                {{"session"}, {"0.9", "", "a model"}, {"0.3", "", "another"}}};
  const std::vector<SourceEntry> entries = sourcesOf(table);
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_THAT(entries[0].cells, testing::ElementsAre("view", "session, Estimate"));
  EXPECT_THAT(entries[0].ids, testing::ElementsAre("view/estimate", ""));
  EXPECT_THAT(entries[1].cells, testing::ElementsAre("session, p"));
}

TEST(ReportDocument, footnotesHaveOneMarkEach) {
  ReportTable table;
  table.rows = {{{"x"}, {"1", "", "", std::nullopt, "first"}, {"2", "", "", std::nullopt, "second"}},
                {{"y"}, {"3", "", "", std::nullopt, "first"}}};
  const std::vector<std::string> footnotes = footnotesOf(table);
  EXPECT_THAT(footnotes, testing::ElementsAre("first", "second"));
  EXPECT_EQ(footnoteMark(footnotes, "second"), "b");
  std::set<std::string> marks;
  std::vector<std::string> many;
  for (int i = 0; i < 800; ++i) {
    many.push_back(std::to_string(i));
  }
  for (const std::string& footnote : many) {
    marks.insert(footnoteMark(many, footnote));
  }
  EXPECT_EQ(marks.size(), many.size());
  EXPECT_EQ(footnoteMark(many, "26"), "aa");
}

}  // namespace
}  // namespace ocelli
