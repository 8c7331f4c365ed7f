#include <gtest/gtest.h>

#include <cmath>

#include "analysis/plot/binned_residual_plot.h"
#include "analysis/plot/model_check_plot.h"

namespace ocelli {
namespace {

size_t partsOf(const Figure& figure, const std::string& part) {
  size_t count = 0;
  for (const Shape& shape : figure.drawing.shapes()) {
    count += shape.part == part ? 1 : 0;
  }
  return count;
}

TEST(ResidualBins, areMeansOfTrialsWithSimilarProbabilities) {
  // Four trials make two bins of two: {0.2, 0.4} with one success, {0.5, 0.9} with two.
  const std::vector<ResidualBin> bins = residualBins({0.9, 0.2, 0.5, 0.4}, {true, false, true, true});
  ASSERT_EQ(bins.size(), 2u);
  EXPECT_NEAR(bins[0].fitted, 0.3, 1e-12);
  EXPECT_NEAR(bins[0].residual, 0.2, 1e-12);
  EXPECT_NEAR(bins[0].bound, 2 * std::sqrt(0.16 + 0.24) / 2, 1e-12);
  EXPECT_NEAR(bins[1].fitted, 0.7, 1e-12);
  EXPECT_NEAR(bins[1].residual, 0.3, 1e-12);
  EXPECT_NEAR(bins[1].bound, 2 * std::sqrt(0.25 + 0.09) / 2, 1e-12);
}

TEST(ResidualBins, holdEveryTrialOnceAndAreAtMostForty) {
  std::vector<double> fitted;
  std::vector<bool> successes;
  for (int i = 0; i < 5003; ++i) {
    fitted.push_back((i % 97 + 1) / 100.0);
    successes.push_back(i % 3 == 0);
  }
  const std::vector<ResidualBin> bins = residualBins(fitted, successes);
  EXPECT_EQ(bins.size(), 40u);
  size_t trials = 0;
  for (const ResidualBin& bin : bins) {
    trials += bin.count;
  }
  EXPECT_EQ(trials, fitted.size());
  EXPECT_TRUE(residualBins({}, {}).empty());
}

TEST(BinnedResidualFigure, drawsEachBinOrSaysThatThereIsNone) {
  EXPECT_EQ(partsOf(binnedResidualFigure({"t", {0.9, 0.2, 0.5, 0.4}, {true, false, true, true}}), "point"), 2u);
  EXPECT_EQ(partsOf(binnedResidualFigure({"t", {}, {}}), "point"), 0u);
}

TEST(QuantileFigure, hasAPanelForEachListOfValues) {
  const QuantilePlot plot{"Random effects", {{"subject", {1, 2, 4, 8}}, {"case", {1, -1, 0}}, {"too few", {1}}}};
  const Figure figure = quantileFigure(plot);
  EXPECT_EQ(partsOf(figure, "point"), 7u);
  EXPECT_EQ(partsOf(figure, "band"), 2u);
  EXPECT_EQ(partsOf(quantileFigure({"none", {}}), "point"), 0u);
}

}  // namespace
}  // namespace ocelli
