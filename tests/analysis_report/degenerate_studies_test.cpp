// Some of the studies of degenerate_studies_slow_test.cpp, which are made into reports in a moment.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "analysis/report/part_guard.h"
#include "tests/analysis_report/degenerate_study.h"
#include "tests/analysis_report/section_study.h"

namespace ocelli::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(DegenerateStudies, haveWholeReports) {
  for (int number = 1000; number < 1004; ++number) {
    const DegenerateStudy study = degenerateStudy(number);
    EXPECT_THAT(problemsOfReport(study), IsEmpty()) << study.name;
  }
}

// ---- The second line of defence.

TEST(PartGuard, aPartThatThrowsGivesANoteAndTheOthersStand) {
  const SectionStudy study;
  ReportDocument document;
  ReportWork work{study.analysis, document};
  addPart(work, "First", [&] {
    work.document.add(ReportParagraph{"before"});
    throw std::overflow_error("t is\ntoo large");
  });
  addPart(work, "Second", [&] { work.document.add(ReportParagraph{"after"}); });
  ASSERT_EQ(document.elements.size(), 3u);
  EXPECT_EQ(std::get<ReportParagraph>(document.elements[0]).text, "before");
  EXPECT_THAT(reasonsOf(document),
              ElementsAre("First: the computation failed, which is a fault of the program (t is too large)."));
  EXPECT_EQ(std::get<ReportParagraph>(document.elements[2]).text, "after");
  EXPECT_THAT(document.failures, ElementsAre("First: t is too large"));
}

TEST(PartGuard, aFigureThatCannotBePaintedGivesANote) {
  const SectionStudy study;
  ReportDocument document;
  ReportWork work{study.analysis, document};
  addFigure(work, "Lines", "figure-lines", [] {
    Figure figure{"Lines", "", 100, 100, {}};
    figure.drawing.line("line", {0, 0}, {std::nan(""), 1}, {});
    return figure;
  });
  addFigure(work, "Text", "figure-text", [] { return Figure{"Text", "", 100, 100, {}}; });
  EXPECT_FALSE(hasFigure(document, "figure-lines"));
  EXPECT_TRUE(hasFigure(document, "figure-text"));
  EXPECT_THAT(reasonsOf(document), ElementsAre(HasSubstr("The figure \"Lines\"")));
  EXPECT_EQ(document.failures.size(), 1u);
}

}  // namespace
}  // namespace ocelli::test
