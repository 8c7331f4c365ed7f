#include "analysis/report/sensitivity.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/analysis_report/hand_made_trials.h"

namespace ocelli {
namespace {

using test::HandMadeTrials;
using test::idsOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

using test::kGc;
using test::kPpc;
constexpr size_t kEnoughRows = 1000000;

std::vector<std::string> labelsOf(const Variants& variants) {
  std::vector<std::string> labels;
  for (const Variant& variant : variants.list) {
    labels.push_back(variant.label);
  }
  return labels;
}

/// Two subjects see two cases in both views, in two sessions; the second subject sees gc first.
HandMadeTrials searches() {
  HandMadeTrials trials("find");
  for (const int subject : {1, 2}) {
    for (const int session : {1, 2}) {
      for (int i = 0; i < 4; ++i) {
        const bool graph = (i >= 2) != (subject == 2);
        trials.add({.subject = fmt::format("S{}", subject),
                    .session = session,
                    .planIndex = i,
                    .caseIndex = i % 2,
                    .view = graph ? kGc : kPpc});
      }
    }
  }
  return trials;
}

TEST(FirstExposures, areTheTrialsInWhichSubjectsMeetCasesForTheFirstTimeInEitherView) {
  const HandMadeTrials trials = searches();
  EXPECT_THAT(idsOf(firstExposures(trials.list())), ElementsAre(1, 2, 9, 10));
  const TrialList reversed(trials.list().rbegin(), trials.list().rend());
  EXPECT_THAT(idsOf(firstExposures(reversed)), ElementsAre(10, 9, 2, 1));
}

TEST(Variants, keepFirstSessionFirstExposuresAndLeaveCasesOut) {
  HandMadeTrials trials = searches();
  trials.add({.subject = "S1", .session = 2, .planIndex = 9, .caseIndex = 1, .dropped = 3});
  const Variants variants = variantsOf(trials.list(), {{"All", trials.list()}}, kEnoughRows);
  EXPECT_THAT(labelsOf(variants), ElementsAre("All", "First session only", "First exposure to each case only",
                                              "Without trials with dropped frames", "Without find block, case 1",
                                              "Without find block, case 2"));
  EXPECT_TRUE(variants.list[0].main);
  EXPECT_THAT(idsOf(variants.list[1].trials), ElementsAre(1, 2, 3, 4, 9, 10, 11, 12));
  EXPECT_THAT(idsOf(variants.list[2].trials), ElementsAre(1, 2, 9, 10));
  EXPECT_EQ(variants.list[3].trials.size(), 16u);
  EXPECT_THAT(idsOf(variants.list[5].trials), ElementsAre(1, 3, 5, 7, 9, 11, 13, 15));
  EXPECT_TRUE(variants.notes.empty()) << variants.notes.front();
}

TEST(Variants, leaveOutWhatWasDoneAgainWhereSomethingWas) {
  HandMadeTrials trials = searches();
  trials.add({.subject = "S1", .planIndex = 8, .caseIndex = 1, .attempt = 2});
  const Variants variants = variantsOf(trials.list(), {{"All", trials.list()}}, kEnoughRows);
  ASSERT_THAT(labelsOf(variants), Contains("Without trials that were done again (1)"));
  const auto found = std::find_if(variants.list.begin(), variants.list.end(), [](const Variant& variant) {
    return variant.label == "Without trials that were done again (1)";
  });
  EXPECT_EQ(found->trials.size(), 16u);
  EXPECT_THAT(idsOf(found->trials), Not(Contains(17)));
}

TEST(Variants, thatKeepTheSameTrialsAreNotedInsteadOfDoneAgain) {
  HandMadeTrials trials;
  trials.add({.caseIndex = 0});
  trials.add({.planIndex = 1, .caseIndex = 1});
  const Variants variants = variantsOf(trials.list(), {{"All", trials.list()}}, kEnoughRows);
  EXPECT_THAT(labelsOf(variants), ElementsAre("All", "Without count block, case 1", "Without count block, case 2"));
  EXPECT_THAT(variants.notes, ElementsAre("First session only: these are the same trials as \"All\".",
                                          "First exposure to each case only: these are the same trials as \"All\".",
                                          "Without trials with dropped frames: these are the same trials as \"All\"."));
}

TEST(Variants, sayThatFirstExposuresCompareViewsBetweenCasesWhereAllSeeTheSameOrder) {
  HandMadeTrials trials("find");
  for (const char* subject : {"S1", "S2"}) {
    trials.add({.subject = subject, .planIndex = 0, .caseIndex = 0, .view = kPpc});
    trials.add({.subject = subject, .planIndex = 1, .caseIndex = 1, .view = kGc});
    trials.add({.subject = subject, .planIndex = 2, .caseIndex = 0, .view = kGc});
    trials.add({.subject = subject, .planIndex = 3, .caseIndex = 1, .view = kPpc});
  }
  EXPECT_THAT(variantsOf(trials.list(), {{"All", trials.list()}}, kEnoughRows).notes,
              Contains(HasSubstr("views are compared between cases")));
}

TEST(Variants, leaveCasesOutInGroupsWhereOneByOneWouldTakeLong) {
  HandMadeTrials trials;
  for (int i = 0; i < 10; ++i) {
    trials.add({.planIndex = i, .caseIndex = i});
  }
  // 30 rows are 3 fits of 10: cases 1, 4, 7, 10, then 2, 5, 8, then 3, 6, 9.
  const Variants variants = variantsOf(trials.list(), {{"All", trials.list()}}, 30);
  ASSERT_EQ(variants.list.size(), 4u);
  EXPECT_EQ(variants.list[1].label, "Without count block, case 1 and 3 more");
  EXPECT_THAT(idsOf(variants.list[1].trials), ElementsAre(2, 3, 5, 6, 8, 9));
  EXPECT_THAT(idsOf(variants.list[3].trials), ElementsAre(1, 2, 4, 5, 7, 8, 10));
  EXPECT_THAT(variants.notes, Contains(HasSubstr("left out in 3 groups")));
}

TEST(Sensitivity, saysAReasonThatAllShareOnce) {
  HandMadeTrials trials;
  for (int i = 0; i < 12; ++i) {
    trials.add({.planIndex = i, .caseIndex = i});
  }
  const AnalysisData analysis;
  ReportDocument document;
  ReportWork work{analysis, document};
  addSensitivity(work, {"s", "Sensitivity", "Ratio", "less", "more"},
                 variantsOf(trials.list(), {{"All", trials.list()}}, kEnoughRows),
                 [](const Variant&) { return Estimable<Estimate>::impossible("there is only one subject"); });
  EXPECT_EQ(test::findTable(document, "s"), nullptr);
  EXPECT_THAT(test::notesOf(document)[0], "All: there is only one subject.");
}

TEST(Sensitivity, hasTheEffectOfEachVariantWithItsTrials) {
  const HandMadeTrials trials = searches();
  const AnalysisData analysis;
  ReportDocument document;
  document.origins.sources = {"study.db"};
  ReportWork work{analysis, document};
  addSensitivity(work, {"s", "Sensitivity", "Ratio", "less", "more"},
                 variantsOf(trials.list(), {{"All", trials.list()}}, kEnoughRows), [](const Variant& variant) {
                   Estimate estimate;
                   estimate.value = static_cast<double>(variant.trials.size());
                   return Estimable<Estimate>(estimate);
                 });
  const ReportTable* table = test::findTable(document, "s");
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(test::findCell(*table, "First session only", 1)->value, 8);
  EXPECT_THAT(test::findCell(*table, "First exposure to each case only", 1)->source,
              HasSubstr("study.db: rows 1-2 9-10"));
}

TEST(Sensitivity, casesThatAreLeftOutStandInTheSupplementAndTheirSpreadInTheReport) {
  HandMadeTrials trials;
  for (int i = 0; i < 12; ++i) {
    trials.add({.planIndex = i, .caseIndex = i});
  }
  const AnalysisData analysis;
  ReportDocument document;
  document.origins.sources = {"study.db"};
  document.add(ReportHeading{1, "Counting objects", "count"});
  ReportWork work{analysis, document};
  int left = 0;
  addSensitivity(work, {"s", "Sensitivity", "Odds ratio, gc / ppc", "less", "more"},
                 variantsOf(trials.list(), {{"All", trials.list()}}, kEnoughRows), [&](const Variant& variant) {
                   Estimate estimate;
                   estimate.value = static_cast<double>(variant.trials.front()->trialId);
                   estimate.pValue = 0.01;
                   return Estimable<Estimate>(estimate);
                 });
  const ReportTable* main = test::findTable(document, "s");
  ASSERT_NE(main, nullptr);
  EXPECT_EQ(main->rows.size(), 1U) << "no case is left out of it";
  std::string spread;
  for (const ReportElement& element : document.elements) {
    if (const auto* paragraph = std::get_if<ReportParagraph>(&element)) {
      spread += paragraph->text;
    }
  }
  EXPECT_THAT(spread, HasSubstr("lies between 1.00 and 2.00; 12 of 12 such fits have p < 0.05"));
  for (const ReportElement& element : document.supplement) {
    if (const auto* table = std::get_if<ReportTable>(&element)) {
      EXPECT_EQ(table->id, "s-cases");
      EXPECT_EQ(table->rows.size(), 13U) << "all, and each of 12 cases";
      ++left;
    }
  }
  EXPECT_EQ(left, 1);
}

}  // namespace
}  // namespace ocelli
