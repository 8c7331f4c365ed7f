#include "analysis/report/view_words.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

std::string labelled(const std::string& text) {
  return withViewLabels(text, defaultConditions());
}

TEST(ViewWords, labelsStandForTheMarks) {
  EXPECT_EQ(labelled("ratio of times, @other@ / @reference@"), "ratio of times, graph camera / pinhole");
  EXPECT_EQ(labelled("@other@ less @reference@: difference. @reference@ alone"),
            "Graph camera less pinhole: difference. Pinhole alone");
  EXPECT_EQ(labelled("with view @other@."), "with view graph camera.");
  EXPECT_EQ(labelled("subject view=@other@"), "subject view=graph camera");
  EXPECT_EQ(labelled("@other@@reference@"), "Graph camerapinhole");
}

TEST(ViewWords, namesStandForTheMarks) {
  EXPECT_EQ(withViewNames("session-1/@other@, @reference@", defaultConditions()), "session-1/gc, ppc");
}

TEST(ViewWords, leaveAllElseAlone) {
  for (const char* text :
       {"", "@", "@@", "gc", "section-7.4.2/stationary/gc", "easier_gc", "me@other.org", "@Other@"}) {
    EXPECT_EQ(labelled(text), text);
    EXPECT_EQ(withViewNames(text, defaultConditions()), text);
  }
}

TEST(ViewWords, labelsStandInAllThatReadersReadAndNamesElsewhere) {
  ReportDocument document;
  document.add(ReportTable{
      "@reference@ and @other@", "gc", {{"What"}, {"@other@"}}, {{{"@reference@"}, {"1", "t/gc", "of @other@", 1}}}});
  ReportTable record{"Subjects", "subjects", {{"Subject"}}, {{{"gc"}}}};
  record.isRecord = true;
  {
    const InSupplement supplement(document);
    document.add(record);
    document.add(ReportFacts{{{"Views", "@other@", true}, {"Words", "@other@"}}});
  }
  document.failures.push_back("the model of @other@");
  spellOutViews(document);
  const auto& table = std::get<ReportTable>(document.elements[0]);
  EXPECT_EQ(table.caption, "Pinhole and graph camera");
  EXPECT_EQ(table.id, "gc");
  EXPECT_EQ(table.columns[1].title, "Graph camera");
  EXPECT_EQ(table.rows[0][0].text, "Pinhole");
  EXPECT_EQ(table.rows[0][1].id, "t/gc");
  EXPECT_EQ(table.rows[0][1].source, "of gc");
  EXPECT_EQ(std::get<ReportTable>(document.supplement[0]).rows[0][0].text, "gc") << "the id of a subject";
  const auto& facts = std::get<ReportFacts>(document.supplement[1]).facts;
  EXPECT_EQ(facts[0].text, "gc");
  EXPECT_EQ(facts[1].text, "Graph camera");
  EXPECT_EQ(document.failures.front(), "the model of gc");
}

TEST(ViewWords, areThoseOfTheStudy) {
  ReportDocument document;
  document.origins.conditions = {{{"flat", "flat view"}, {"on", "bent view"}}};
  document.add(ReportParagraph{"@other@ less @reference@, depending on the view"});
  spellOutViews(document);
  EXPECT_EQ(std::get<ReportParagraph>(document.elements[0]).text, "Bent view less flat view, depending on the view");
}

}  // namespace
}  // namespace ocelli
