#include "analysis/tables/explain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/dataset/merge.h"
#include "analysis/tables/paper_tables.h"
#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

using ::testing::HasSubstr;

struct Explain : ::testing::Test {
  SampleFolder folder;
  std::string path = folder.file("it's.db");

  std::string of(const std::string& cell) {
    const AnalysisData data = applyPlan(merge({readSource(path)}), AnalysisPlan());
    return explainCell(paperTables(data), data.data, cell);
  }
};

TEST_F(Explain, listsTheRowsAndTheirQuery) {
  SampleStudy study(path);
  fillSmallStudy(study);
  const std::string text = of("section-7.4.2/stationary/gc");
  EXPECT_THAT(text, HasSubstr("section-7.4.2/stationary/gc: 6.0 s (n = 2)"));
  EXPECT_THAT(text, HasSubstr("\"SELECT * FROM final_trial WHERE trial_id IN (2, 8)\""));
  EXPECT_THAT(text, HasSubstr("it'\\''s.db' "));
  EXPECT_THAT(text, HasSubstr("1  8  S02  1  find stationary/location 1  gc  6  no  yes  here  here\n"));
}

TEST_F(Explain, followsCellsToTheirParts) {
  SampleStudy study(path);
  fillSmallStudy(study);
  const std::string text = of("section-7.4.2/stationary/faster");
  EXPECT_THAT(text, HasSubstr("from section-7.4.2/stationary/ppc: 11.0 s (n = 1)"));
  EXPECT_THAT(text, HasSubstr("IN (2, 8)"));
  EXPECT_THAT(of("section-7.4.5/easier-find"), HasSubstr("FROM final_answer WHERE answer_id IN (2, 4)"));
  EXPECT_THAT(of("subjects/analysed"), HasSubstr("S01\nS02\n"));
  EXPECT_THAT(of("table-7.3/stationary/session-1/gc/published"), HasSubstr("not from these data"));
}

TEST_F(Explain, namesCellsThatAreClose) {
  SampleStudy study(path);
  EXPECT_THAT(analysisErrorOf([&] { of("table-7.1/stationary/session-1/g"); }),
              HasSubstr("such as table-7.1/stationary/session-1/gc"));
}

}  // namespace
}  // namespace ocelli::test
