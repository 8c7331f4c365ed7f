#include "analysis/report/view_words.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(ViewWords, standForTheShortNames) {
  EXPECT_EQ(withViewWords("ratio of times, gc / ppc"), "ratio of times, graph camera / pinhole");
  EXPECT_EQ(withViewWords("gc less ppc: difference. ppc alone"),
            "Graph camera less pinhole: difference. Pinhole alone");
  EXPECT_EQ(withViewWords("with view gc."), "with view graph camera.");
  EXPECT_EQ(withViewWords("subject view=gc"), "subject view=graph camera");
}

TEST(ViewWords, leaveNamesAlone) {
  for (const char* name : {"section-7.4.2/stationary/gc", "easier_gc", "gcc", "ppc-3", "b/ppc/c"}) {
    EXPECT_EQ(withViewWords(name), name);
  }
}

TEST(ViewWords, standInAllThatReadersReadButNotInRecordsIdsAndSources) {
  ReportDocument document;
  document.add(ReportTable{"ppc and gc", "gc", {{"What"}, {"gc"}}, {{{"ppc"}, {"1", "t/gc", "of gc", 1}}}});
  ReportTable record{"Subjects", "subjects", {{"Subject"}}, {{{"gc"}}}};
  record.isRecord = true;
  {
    const InSupplement supplement(document);
    document.add(record);
    document.add(ReportFacts{{{"Views", "gc", true}, {"Words", "gc"}}});
  }
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
}

}  // namespace
}  // namespace ocelli
