// Every chart of numbers can be painted whatever these are: none, one, all alike, alike up to rounding, absurd ones.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "analysis/plot/binned_residual_plot.h"
#include "analysis/plot/model_check_plot.h"
#include "analysis/plot/paired_plot.h"
#include "analysis/plot/power_plot.h"
#include "tests/analysis_plot/sample_figures.h"

namespace ocelli {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

std::vector<std::vector<double>> degenerateValues() {
  return {{},
          {7},
          {0},
          {7, 7, 7},
          {0, 0},
          {7, std::nextafter(7.0, 8)},
          {std::nextafter(0.05, 0), 0.05, std::nextafter(0.05, 1)},
          {1e-9, 1e-9, 2e-9},
          {1e9, 1e9 + 1e-6},
          {1e-9, 1e9},
          {1e-300, 1e300},
          {-1e300, 1e300},
          {-7, -7},
          {kNaN, kNaN},
          {kInf, 1, 2},
          {-kInf, kInf},
          {5e-324, 1}};
}

std::vector<Figure> figuresOf(const std::vector<double>& values) {
  std::vector<Figure> figures;
  const double first = values.empty() ? kNaN : values.front();
  const double last = values.empty() ? kNaN : values.back();
  for (const AxisScale scale : {AxisScale::kLinear, AxisScale::kLog}) {
    for (const bool rows : {false, true}) {
      GroupPlot group;
      group.valueLabel = "Time (s)";
      group.scale = scale;
      group.rows = rows;
      group.connected = !rows;
      group.conditions = {"1", "2"};
      group.series = {{"ppc", {{{first, first, last}, values}, {{last, kNaN, kNaN}, values}}},
                      {"gc", {{{first, 1e-200, 1e200}, values}, {{kNaN, kNaN, kNaN}, {}}}}};
      figures.push_back(groupFigure(group));
    }
    PairedPlot paired;
    paired.scale = scale;
    for (const double value : values) {
      paired.pairs.push_back({value, first});
    }
    paired.summaries = {{{first, first, last}, {kNaN, kNaN, kNaN}}};
    figures.push_back(pairedFigure(paired));
    ForestPlot forest;
    forest.ratio = scale == AxisScale::kLog;
    for (const double value : values) {
      forest.rows.push_back({"a", {value, first, last}});
    }
    figures.push_back(forestFigure(forest));
  }
  SurvivalPlot survival;
  survival.limit = std::isnan(last) ? 60 : last;
  SurvivalPlot::Curve curve{"ppc", {}, {}, {}};
  for (const double value : values) {
    curve.steps.push_back({value, 0.5, 0.5, 0.5});
    curve.censoredTimes.push_back(value);
  }
  survival.curves = {curve};
  survival.riskTimes = {0, survival.limit};
  figures.push_back(survivalFigure(survival));
  ModelCheckPlot check;
  check.fitted = values;
  check.residuals = values;
  figures.push_back(modelCheckFigure(check));
  QuantilePlot quantiles;
  quantiles.panels = {{"subject", values}, {"case", values}};
  figures.push_back(quantileFigure(quantiles));
  HeatMap heat;
  heat.maps = {{"ppc", {}, {}}};
  for (size_t i = 0; i < values.size(); ++i) {
    heat.maps[0].cells.push_back({static_cast<double>(i), 0, values[i]});
  }
  figures.push_back(heatFigure(heat));
  PowerPlot power;
  power.curves = {{"a", {}}};
  for (const double value : values) {
    power.curves[0].points.push_back({value, {0.5, 0.5, 0.5}});
  }
  figures.push_back(powerFigure(power));
  return figures;
}

TEST(DegenerateFigures, areFinite) {
  const std::vector<std::vector<double>> all = degenerateValues();
  for (size_t i = 0; i < all.size(); ++i) {
    size_t number = 0;
    for (const Figure& figure : figuresOf(all[i])) {
      SCOPED_TRACE(testing::Message() << "values " << i << ", figure " << number++);
      EXPECT_TRUE(isFinite(figure.drawing));
      EXPECT_TRUE(std::isfinite(figure.width) && std::isfinite(figure.height));
    }
  }
}

TEST(DegenerateFigures, arePainted) {
  for (const std::vector<double>& values : {std::vector{7, std::nextafter(7.0, 8)}, std::vector{1e-300, 1e300}}) {
    for (const Figure& figure : figuresOf(values)) {
      EXPECT_NO_THROW(svgText(figure));
    }
  }
}

TEST(DegenerateFigures, probabilitiesThatAreAllAlikeHaveBinnedResiduals) {
  for (const double probability : {0.0, 0.5, 1.0, std::nextafter(1.0, 0)}) {
    BinnedResidualPlot plot;
    plot.fitted = {probability, probability, probability};
    plot.successes = {true, true, false};
    const Figure figure = binnedResidualFigure(plot);
    EXPECT_TRUE(isFinite(figure.drawing)) << probability;
    EXPECT_NO_THROW(svgText(figure)) << probability;
  }
}

TEST(Axis, alikeUpToRoundingIsWidened) {
  for (const AxisScale scale : {AxisScale::kLinear, AxisScale::kLog}) {
    const Axis axis(AxisRange::of({7, std::nextafter(7.0, 8)}, scale), 0, 300, [](const std::string&) { return 10.0; });
    EXPECT_LT(axis.low(), 6.9);
    EXPECT_GT(axis.high(), 7.1);
    EXPECT_GT(axis.at(7), 0);
    EXPECT_LT(axis.at(7), 300);
  }
}

}  // namespace
}  // namespace ocelli
