// Nothing that a data set holds may end a report: 300 small and degenerate studies all have a whole one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis_report/degenerate_study.h"

namespace ocelli::test {
namespace {

constexpr int kGroups = 30;
constexpr int kStudiesOfGroup = 10;

class DegenerateStudies : public testing::TestWithParam<int> {};

TEST_P(DegenerateStudies, haveWholeReports) {
  for (int i = 0; i < kStudiesOfGroup; ++i) {
    const DegenerateStudy study = degenerateStudy(GetParam() * kStudiesOfGroup + i);
    EXPECT_THAT(problemsOfReport(study), testing::IsEmpty()) << study.name;
  }
}

INSTANTIATE_TEST_SUITE_P(ThreeHundred, DegenerateStudies, testing::Range(0, kGroups));

}  // namespace
}  // namespace ocelli::test
