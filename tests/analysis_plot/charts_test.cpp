// What holds for every chart, and where the values of some of them lie.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/plot/flow_diagram.h"
#include "analysis/plot/model_check_plot.h"
#include "analysis/plot/paired_plot.h"
#include "analysis/plot/style.h"
#include "analysis/plot/trade_off_plot.h"
#include "tests/analysis_plot/sample_figures.h"

namespace ocelli {
namespace {

std::vector<PlotBox> boxesOf(const Figure& figure, const std::string& part) {
  std::vector<PlotBox> boxes;
  for (const Shape& shape : figure.drawing.shapes()) {
    if (shape.part == part) {
      boxes.push_back(boxOf(shape));
    }
  }
  return boxes;
}

std::vector<std::string> textsOf(const Figure& figure, const std::string& part) {
  std::vector<std::string> texts;
  for (const Shape& shape : figure.drawing.shapes()) {
    if (shape.part == part) {
      texts.push_back(std::get<TextShape>(shape.what).text);
    }
  }
  return texts;
}

std::vector<SampleFigure> everyFigure() {
  std::vector<SampleFigure> all = sampleFigures();
  for (const auto& more : {emptyFigures(), tinyFigures()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

TEST(Charts, nothingLeavesTheFigure) {
  for (const SampleFigure& sample : everyFigure()) {
    const PlotBox paper{0, 0, sample.figure.width, sample.figure.height};
    for (const Shape& shape : sample.figure.drawing.shapes()) {
      const PlotBox box = boxOf(shape);
      EXPECT_TRUE(paper.contains(box, 1.5)) << sample.name << ": " << shape.part << " " << box.left << " " << box.top
                                            << " " << box.right << " " << box.bottom;
    }
  }
}

TEST(Charts, textIsLegibleAndDoesNotOverlap) {
  for (const SampleFigure& sample : everyFigure()) {
    std::vector<std::pair<std::string, PlotBox>> texts;
    for (const Shape& shape : sample.figure.drawing.shapes()) {
      if (const auto* text = std::get_if<TextShape>(&shape.what); text != nullptr && !text->text.empty()) {
        EXPECT_GE(text->size, 8) << sample.name << ": " << text->text;
        PlotBox box = boxOf(shape);
        // Lines may stand close; letters may not touch.
        box.top += 0.8;
        box.bottom -= 0.8;
        for (const auto& [other, otherBox] : texts) {
          EXPECT_FALSE(box.overlaps(otherBox)) << sample.name << ": " << text->text << " on " << other;
        }
        texts.emplace_back(text->text, box);
      }
    }
  }
}

TEST(Charts, everyFigureIsDescribedWithoutNaN) {
  for (const SampleFigure& sample : everyFigure()) {
    EXPECT_FALSE(sample.figure.title.empty()) << sample.name;
    EXPECT_GT(sample.figure.description.size(), 15U) << sample.name;
    EXPECT_THAT(sample.figure.description, testing::Not(testing::HasSubstr("nan"))) << sample.name;
    for (const Shape& shape : sample.figure.drawing.shapes()) {
      const PlotBox box = boxOf(shape);
      EXPECT_TRUE(std::isfinite(box.left + box.top + box.right + box.bottom)) << sample.name << ": " << shape.part;
    }
  }
}

TEST(Charts, withoutDataThereIsANote) {
  for (const SampleFigure& sample : emptyFigures()) {
    EXPECT_FALSE(textsOf(sample.figure, "note").empty()) << sample.name;
    EXPECT_THAT(sample.figure.description, testing::StartsWith("No data")) << sample.name;
  }
}

TEST(Charts, fitTheColumnsOfAPaper) {
  for (const SampleFigure& sample : sampleFigures()) {
    const double millimetres = sample.figure.width / kPointsPerMillimetre;
    EXPECT_TRUE(std::abs(millimetres - 85) < 1e-9 || std::abs(millimetres - 170) < 1e-9) << sample.name;
  }
}

TEST(GroupPlot, higherValuesStandHigher) {
  const GroupPlot plot = sampleLearning();
  const std::vector<PlotBox> summaries = boxesOf(groupFigure(plot), "summary");
  ASSERT_EQ(summaries.size(), 6U);
  // Linear: heights from the first summary are as the values.
  const auto value = [&](size_t i) { return plot.series[i / 3].groups[i % 3].summary.value; };
  const double scale = (summaries[3].middleY() - summaries[0].middleY()) / (value(0) - value(3));
  for (size_t i = 1; i < 6; ++i) {
    EXPECT_NEAR(summaries[i].middleY() - summaries[0].middleY(), scale * (value(0) - value(i)), 1e-6);
  }
}

TEST(GroupPlot, everyRawValueIsDrawn) {
  EXPECT_EQ(boxesOf(groupFigure(sampleLearning()), "point").size(), 150U);
  EXPECT_EQ(boxesOf(groupFigure(sampleLearning()), "link").size(), 100U);
  EXPECT_EQ(boxesOf(groupFigure(sampleCases()), "point").size(), 12U * 2 * 22);
}

TEST(GroupPlot, moreThanCanBeDrawnIsSaid) {
  GroupPlot plot = sampleLearning();
  plot.linked = false;
  plot.series[0].groups[0].raw.assign(5000, 10);
  const Figure figure = groupFigure(plot);
  EXPECT_THAT(figure.description, testing::HasSubstr("5000 values of which 1200 are drawn"));
  EXPECT_EQ(boxesOf(figure, "point").size(), 1200U + 125);
}

TEST(GroupPlot, sharesThatAreAllAlikeStillEndAtOne) {
  GroupPlot plot;
  plot.title = "All right";
  plot.percent = true;
  plot.conditions = {"1"};
  plot.series = {{"ppc", {{{1, 1, 1}, {1, 1}}}}};
  EXPECT_THAT(textsOf(groupFigure(plot), "tick label").back(), testing::StartsWith("100"));
}

TEST(FigureGrid, chartsStandBesideEachOtherUnderTheirTitles) {
  const FigureGrid grid = sampleGrid();
  const Figure figure = gridFigure(grid);
  const std::vector<PlotBox> titles = boxesOf(figure, "chart title");
  ASSERT_EQ(titles.size(), 3U);
  EXPECT_EQ(titles[0].top, titles[1].top);
  EXPECT_NEAR(titles[1].left - titles[0].left, figure.width / 2 + kGridGapPoints / 2, 1e-9);
  EXPECT_EQ(titles[2].left, titles[0].left);
  EXPECT_GT(titles[2].top, titles[0].top + grid.figures[0].height);
  size_t points = 0;
  for (const Figure& each : grid.figures) {
    points += boxesOf(each, "point").size();
  }
  EXPECT_EQ(boxesOf(figure, "point").size(), points);
  EXPECT_EQ(textsOf(figure, "legend").size(), grid.legend.size());
}

TEST(PairedPlot, linesJoinTheValuesOfASubject) {
  PairedPlot plot;
  plot.title = "Two subjects";
  plot.conditions = {"flat", "bent"};
  plot.pairs = {{10, 5}, {20, 20}};
  const Figure figure = pairedFigure(plot);
  const std::vector<PlotBox> points = boxesOf(figure, "point");
  const std::vector<PlotBox> links = boxesOf(figure, "link");
  ASSERT_EQ(points.size(), 4U);
  ASSERT_EQ(links.size(), 2U);
  EXPECT_NEAR(links[0].top, points[0].middleY(), 1e-9);
  EXPECT_NEAR(links[0].bottom, points[1].middleY(), 1e-9);
  EXPECT_NEAR(links[1].height(), 0, 1e-9);
  EXPECT_THAT(figure.description, testing::HasSubstr("higher with bent for 0 subjects, lower for 1, the same for 1"));
}

TEST(TradeOffPlot, joinsTheConditionsOfASubjectAndLeavesOutWhatIsNotKnown) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  TradeOffPlot plot;
  plot.title = "Three subjects";
  plot.conditions = {{"flat", {{2, 0.5}, {4, 1}, {nan, nan}}, {std::sqrt(8.0), 0.75}},
                     {"bent", {{4, 0.5}, {nan, nan}, {8, 0}}, {std::sqrt(32.0), 0.25}}};
  const Figure figure = tradeOffFigure(plot);
  const std::vector<PlotBox> points = boxesOf(figure, "point");
  ASSERT_EQ(points.size(), 4U);
  const std::vector<PlotBox> links = boxesOf(figure, "link");
  ASSERT_EQ(links.size(), 1U);
  EXPECT_NEAR(links[0].height(), 0, 1e-9);  // as often right with both
  // Times are on a logarithmic axis: 2 to 4 s is as far as 4 to 8.
  EXPECT_NEAR(points[2].middleX() - points[0].middleX(), points[3].middleX() - points[2].middleX(), 1e-6);
  EXPECT_THAT(figure.description, testing::HasSubstr("of 3 subjects. Means: flat 2.83 s, 75 %; bent 5.66 s, 25 %."));
}

TEST(SurvivalPlot, bandsHoldTheirCurvesInsideThePanel) {
  const Figure figure = survivalFigure(sampleSurvival());
  const std::vector<PlotBox> bands = boxesOf(figure, "band");
  const std::vector<PlotBox> curves = boxesOf(figure, "curve");
  const std::vector<PlotBox> axes = boxesOf(figure, "axis");
  ASSERT_EQ(bands.size(), 2U);
  ASSERT_EQ(curves.size(), 2U);
  ASSERT_EQ(axes.size(), 2U);
  const PlotBox area{std::min(axes[0].left, axes[1].left), std::min(axes[0].top, axes[1].top),
                     std::max(axes[0].right, axes[1].right), std::max(axes[0].bottom, axes[1].bottom)};
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(bands[i].contains(curves[i], 1e-9));
    EXPECT_TRUE(area.contains(bands[i], 1e-9));
  }
}

TEST(SurvivalPlot, stepsFallAtTheirTimes) {
  SurvivalPlot plot;
  plot.title = "One of two found";
  plot.curves = {{"ppc", {{30, 0.5, 0.1, 0.9}}, {60}, {2, 1}}};
  plot.riskTimes = {0, 60};
  const Figure figure = survivalFigure(plot);
  for (const Shape& shape : figure.drawing.shapes()) {
    if (shape.part == "curve") {
      const std::vector<PlotPoint>& line = std::get<PathShape>(shape.what).lines.front();
      ASSERT_EQ(line.size(), 4U);
      EXPECT_NEAR(line[1].x, (line[0].x + line[3].x) / 2, 1e-9) << "30 of 60 s";
      EXPECT_EQ(line[1].x, line[2].x);
      EXPECT_EQ(line[0].y, line[1].y);
      EXPECT_LT(line[1].y, line[2].y);
    }
  }
  EXPECT_EQ(boxesOf(figure, "censored").size(), 1U);
  EXPECT_THAT(textsOf(figure, "at risk"), testing::ElementsAre("2", "1"));
}

TEST(SurvivalPlot, bandsGoFromTheLowerToTheUpperEnd) {
  SurvivalPlot plot;
  plot.title = "One step";
  plot.curves = {{"ppc", {{30, 0.5, 0.2, 0.9}}, {}, {}}};
  const Figure figure = survivalFigure(plot);
  const PlotBox axis = boxesOf(figure, "axis").front();  // the upright one
  std::vector<double> heights;                           // at the end of the time, as shares
  for (const Shape& shape : figure.drawing.shapes()) {
    if (shape.part == "band") {
      for (const PlotPoint& point : std::get<PathShape>(shape.what).lines.front()) {
        if (point.x > axis.right + 10 && point.x >= boxOf(shape).right - 1e-9) {
          heights.push_back((axis.bottom - point.y) / axis.height());
        }
      }
    }
  }
  EXPECT_THAT(heights, testing::UnorderedElementsAre(testing::DoubleNear(0.9, 1e-9), testing::DoubleNear(0.2, 1e-9)));
}

TEST(SurvivalPlot, numbersAtRiskStandBelowTheirTimes) {
  const Figure figure = survivalFigure(sampleSurvival());
  std::vector<double> ticks;
  for (const Shape& shape : figure.drawing.shapes()) {
    if (shape.part == "tick label" && std::get<TextShape>(shape.what).text.find('%') == std::string::npos) {
      ticks.push_back(boxOf(shape).middleX());
    }
  }
  const std::vector<PlotBox> numbers = boxesOf(figure, "at risk");
  ASSERT_EQ(numbers.size(), 2 * ticks.size());
  for (size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_NEAR(numbers[i].middleX(), ticks[i % ticks.size()], 1e-6);
  }
}

TEST(ForestPlot, farIntervalsEndInArrowsAndKeepTheirNumbers) {
  const Figure figure = forestFigure(sampleForest());
  EXPECT_EQ(boxesOf(figure, "arrow").size(), 2U);
  EXPECT_THAT(textsOf(figure, "numbers"), testing::Contains("0.90 (0.050 to 31.0)"));
  EXPECT_THAT(textsOf(figure, "numbers"), testing::Contains("no frames recorded"));
  const PlotBox reference = boxesOf(figure, "reference").front();
  EXPECT_LT(boxesOf(figure, "summary").front().right, reference.left) << "0.66 lies below 1";
}

TEST(HeatMap, equalValuesHaveEqualShadesAndMoreIsDarker) {
  HeatMap map;
  map.title = "Three cells";
  map.maps = {{"ppc", {{0, 0, 1}, {1, 0, 4}, {2, 0, 1}}, {}}};
  std::vector<double> reds;
  const Figure figure = heatFigure(map);
  for (const Shape& shape : figure.drawing.shapes()) {
    if (shape.part == "cell") {
      reds.push_back(std::get<PathShape>(shape.what).fill->red);
    }
  }
  ASSERT_EQ(reds.size(), 3U);
  EXPECT_EQ(reds[0], reds[2]);
  EXPECT_LT(reds[1], reds[0]);
}

TEST(ModelCheck, orderOfNormalSamplesIsSymmetricAndKnown) {
  // One of one: the normal distribution itself.
  EXPECT_NEAR(normalOrder(0, 1).lower, -1.959964, 1e-6);
  EXPECT_NEAR(normalOrder(0, 1).median, 0, 1e-9);
  // The greatest of two: its median m has Phi(m)^2 = 1/2.
  EXPECT_NEAR(normalOrder(1, 2).median, 0.544952, 1e-5);
  EXPECT_NEAR(normalOrder(0, 9).upper, -normalOrder(8, 9).lower, 1e-9);
  for (size_t n = 1; n < 200; n += 2) {
    EXPECT_NEAR(normalOrder(n / 2, n).median, 0, 1e-9) << n;
  }
}

TEST(FlowDiagram, everyoneIsInABox) {
  FlowDiagram diagram;
  diagram.title = "Subjects";
  diagram.stages = {{"Consented", 47, "subjects", {{"ill", 1}, {"left", 1}}}, {"Analysed", 45}};
  const Figure figure = flowFigure(diagram);
  EXPECT_EQ(boxesOf(figure, "stage").size(), 2U);
  EXPECT_EQ(boxesOf(figure, "loss").size(), 1U);
  EXPECT_THAT(textsOf(figure, "loss text"), testing::Contains("Not continued: 2"));
  EXPECT_FALSE(boxesOf(figure, "stage")[1].overlaps(boxesOf(figure, "loss")[0]));
}

}  // namespace
}  // namespace ocelli
