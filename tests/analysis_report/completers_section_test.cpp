#include "analysis/report/completers_section.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/analysis_report/hand_made_trials.h"
#include "tests/analysis_report/section_study.h"

namespace ocelli::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

ReportDocument completersOf(const SectionStudy& study, const std::vector<std::string>& tasks = {"find"}) {
  return documentOf(study.analysis, [&](ReportWork& work) { addCompletersSection(work, rowsOf(tasks)); });
}

/// C1 and C2 complete both sessions, D1 and D2 the first alone. Seconds of ppc and gc in the first session.
SectionStudy twoAndTwo() {
  SectionStudy study;
  const std::tuple<const char*, int, double, double> subjects[] = {
      {"C1", 2, 8, 8}, {"C2", 2, 16, 16}, {"D1", 1, 16, 8}, {"D2", 1, 64 / 2.0, 16}};
  for (const auto& [subject, sessions, pinhole, graph] : subjects) {
    study.complete(subject, sessions);
    study.add(subject, 1, kPpc, pinhole);
    study.add(subject, 1, kGc, graph);
  }
  study.add("C1", 2, kPpc, 1);  // of no concern
  return study;
}

TEST(CompletersSection, comparesFirstSessions) {
  const ReportDocument document = completersOf(twoAndTwo());
  const std::string table = "completers-find";
  // Geometric means 8 and 16; 8 sqrt 2 and 16 sqrt 2.
  EXPECT_NEAR(*cellValue(document, table, "Geometric mean time (s), as a ratio", "Completed"), 8 * std::sqrt(2.0),
              1e-12);
  EXPECT_NEAR(*cellValue(document, table, "Geometric mean time (s), as a ratio", "Did not"), 16, 1e-12);
  EXPECT_NEAR(*cellValue(document, table, "Geometric mean time (s), as a ratio", "Did not, against completed"),
              std::sqrt(2.0), 1e-12);
  // Either group has a variance of (ln 2)^2 / 2 and two subjects: error ln 2 / sqrt 2, 2 degrees of freedom.
  const Cell& upper = originOf(document, table + "/geometric-mean-time-s-as-a-ratio-compared/upper");
  EXPECT_NEAR(*upper.value, std::exp(std::log(2.0) / 2 + 4.302652729911 * std::log(2.0) / std::sqrt(2.0)), 1e-8);
  // Views: 1 in both completers, a half in both others.
  EXPECT_EQ(cellText(document, table, "Effect of the view on times, gc / ppc, as a ratio", "Did not"), "0.500");
  // Means of all searches, none of which was censored: 12 and 18.
  EXPECT_NEAR(*cellValue(document, table, "Restricted mean to 60 s (s)", "Completed"), 12, 1e-12);
  EXPECT_NEAR(*cellValue(document, table, "Restricted mean to 60 s (s)", "Did not, against completed"), 6, 1e-12);
  EXPECT_EQ(cellText(document, table, "Restricted mean to 60 s (s)", "Subjects"), "2, 2");
  EXPECT_TRUE(hasFigure(document, "figure-completers"));
  const auto* said = std::get_if<ReportParagraph>(&document.elements[1]);
  ASSERT_NE(said, nullptr);
  EXPECT_THAT(said->text, HasSubstr("2 of 4 analysed subjects completed the 2 planned sessions"));
  EXPECT_THAT(said->text, HasSubstr("2 of them completed 1"));
  EXPECT_THAT(said->text, HasSubstr("descriptive"));
}

TEST(CompletersSection, comparesSharesOfRightAnswers) {
  SectionStudy study;
  for (const auto& [subject, sessions, right] :
       {std::tuple{"C1", 2, true}, {"C2", 2, false}, {"D1", 1, false}, {"D2", 0, false}}) {
    study.complete(subject, sessions);
    study.add(subject, 1, kPpc, 1, right, "count");
    study.add(subject, 1, kGc, 1, true, "count");
  }
  const ReportDocument document = completersOf(study, {"count", "path"});
  // Shares 1 and 0.5; 0.5 and 0.5.
  EXPECT_EQ(*cellValue(document, "completers-count", "Share of right answers", "Completed"), 0.75);
  EXPECT_EQ(cellText(document, "completers-count", "Share of right answers", "Did not"), "0.500");
  EXPECT_EQ(*cellValue(document, "completers-count", "Share of right answers", "Did not, against completed"), -0.25);
  EXPECT_EQ(*cellValue(document, "completers-count", "Effect of the view on it, gc less ppc", "Completed"), 0.5);
  EXPECT_THAT(reasonsOf(document), ElementsAre("Recognising paths, first session: there are no trials of it."));
}

TEST(CompletersSection, aSingleSubjectIsNoGroup) {
  SectionStudy study = twoAndTwo();
  std::erase_if(study.analysis.data.trials, [](const Trial& trial) { return trial.subject == "D2"; });
  const ReportDocument document = completersOf(study);
  EXPECT_EQ(cellText(document, "completers-find", "Geometric mean time (s), as a ratio", "Did not"), "-");
  EXPECT_THAT(reasonsOf(document), Contains(HasSubstr("only one subject has such trials")));
  EXPECT_THAT(reasonsOf(document), Contains(HasSubstr("the groups have 2 and 1 values")));
}

std::string onlyReason(const SectionStudy& study) {
  const std::vector<std::string> reasons = reasonsOf(completersOf(study));
  return reasons.size() == 1 ? reasons.front() : "not one reason";
}

TEST(CompletersSection, saysWhereThereIsOneGroup) {
  SectionStudy all;
  all.complete("S1", 2);
  all.add("S1", 1, kPpc, 1);
  EXPECT_THAT(onlyReason(all), HasSubstr("all 1 analysed subjects completed the 2 planned sessions"));
  SectionStudy none;
  none.add("S1", 1, kPpc, 1);
  EXPECT_THAT(onlyReason(none), HasSubstr("none of 1 analysed subjects completed the 2 planned sessions"));
  EXPECT_THAT(onlyReason(SectionStudy(1)), HasSubstr("the protocol has one session only"));
  EXPECT_THAT(onlyReason(SectionStudy(0)), HasSubstr("it is not known how many sessions were planned"));
}

}  // namespace
}  // namespace ocelli::test
