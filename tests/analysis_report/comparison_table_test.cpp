#include "analysis/report/comparison_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis_report/section_study.h"

namespace ocelli::test {
namespace {

using ::testing::ElementsAre;

TEST(ComparisonTable, numbersHaveTheDigitsThatTheirIntervalBears) {
  EXPECT_EQ(estimateText(3.3689, 2.391, 4.347), "3.37 (2.39 to 4.35)");
  EXPECT_EQ(estimateText(0.0315, -2.82, 2.88), "0.0 (-2.8 to 2.9)");
  EXPECT_EQ(estimateText(-0.04, -2.82, 2.88), "0.0 (-2.8 to 2.9)");
  EXPECT_EQ(estimateText(4321.4, 4202.6, 4500.9), "4321 (4203 to 4501)");
  EXPECT_EQ(estimateText(0.00123456, 0.00122, 0.00125), "0.001235 (0.001220 to 0.001250)");
  EXPECT_EQ(estimateText(22, 0.00295, 165623), "22.000 (0.003 to 165623.000)");
  EXPECT_EQ(estimateText(1, kNotKnown, kNotKnown), "1.00");
  EXPECT_EQ(estimateText(1, 1, 1), "1.00");
}

EstimateRow rowOf(const std::string& label, double value) {
  Estimate estimate;
  estimate.value = value;
  estimate.lower = value - 1;
  estimate.upper = value + 1;
  estimate.pValue = 0.03;
  return {label, estimate, "", "by hand"};
}

EstimateRow without(const std::string& label, const std::string& reason) {
  return {label, Estimable<Estimate>::impossible(reason)};
}

TEST(ComparisonTable, reasonsStandOnceForAllThatTheyHide) {
  ReportDocument document;
  ComparisonTable table;
  table.id = "t";
  table.rows = {{"a", rowOf("a, ppc", 3), without("a, gc", "none came"), without("a, both", "none in both"), "1"},
                {"b", without("b, ppc", "none came"), without("b, gc", "none came"), without("b, both", "none"), "0"}};
  addComparison(document, table);
  EXPECT_EQ(cellText(document, "t", "a", "ppc"), "3.0 (2.0 to 4.0)");
  EXPECT_EQ(cellText(document, "t", "a", "gc"), "-");
  EXPECT_EQ(cellText(document, "t", "a", "p"), "-");
  EXPECT_EQ(cellText(document, "t", "b", "ppc"), "no such cell");
  EXPECT_THAT(reasonsOf(document),
              ElementsAre("a, gc; b, ppc; b, gc: none came.", "a, both: none in both.", "b, both: none."));
}

TEST(ComparisonTable, thePValueIsThatOfTheDifference) {
  ReportDocument document;
  ComparisonTable table;
  table.id = "t";
  table.rows = {{"a", rowOf("a, ppc", 3), rowOf("a, gc", 4), rowOf("a, both", 1), "2"}};
  addComparison(document, table);
  EXPECT_EQ(cellText(document, "t", "a", "p"), "0.030");
  table.id = "u";
  table.tested = false;
  addComparison(document, table);
  EXPECT_EQ(cellText(document, "u", "a", "p"), "no such cell");
  EXPECT_EQ(cellText(document, "u", "a", "Subjects"), "2");
}

}  // namespace
}  // namespace ocelli::test
