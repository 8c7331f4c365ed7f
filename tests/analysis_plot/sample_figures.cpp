#include "tests/analysis_plot/sample_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/plot/estimate_plot.h"
#include "analysis/plot/flow_diagram.h"
#include "analysis/plot/histogram_plot.h"
#include "analysis/plot/model_check_plot.h"
#include "analysis/plot/paired_plot.h"
#include "analysis/plot/power_plot.h"
#include "analysis/plot/psychometric_plot.h"
#include "analysis/plot/rating_plot.h"
#include "analysis/plot/rose_plot.h"
#include "analysis/plot/trade_off_plot.h"

namespace ocelli {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Interval meanOf(const std::vector<double>& values) {
  double mean = 0;
  for (const double value : values) {
    mean += value / static_cast<double>(values.size());
  }
  double sum = 0;
  for (const double value : values) {
    sum += (value - mean) * (value - mean);
  }
  const auto n = static_cast<double>(values.size());
  const double half = 1.96 * std::sqrt(sum / (n - 1) / n);
  return {mean, mean - half, mean + half};
}

Interval shareOf(const std::vector<double>& shares) {
  const Interval mean = meanOf(shares);
  return {mean.value, std::max(0.0, mean.lower), std::min(1.0, mean.upper)};
}

std::vector<double> times(SampleNumbers& numbers, size_t count, double median) {
  std::vector<double> values;
  for (size_t i = 0; i < count; ++i) {
    values.push_back(std::min(60.0, median * std::exp(0.5 * numbers.normal())));
  }
  return values;
}

std::vector<double> shares(SampleNumbers& numbers, size_t count, double share) {
  std::vector<double> values;
  for (size_t i = 0; i < count; ++i) {
    int right = 0;
    for (int k = 0; k < 10; ++k) {
      right += numbers.uniform() < share ? 1 : 0;
    }
    values.push_back(right / 10.0);
  }
  return values;
}

EstimatePlot sampleEstimates() {
  SampleNumbers numbers(21);
  EstimatePlot plot;
  plot.title = "Estimates against the truth";
  plot.unit = "metres";
  for (const double exponent : {0.95, 0.75}) {
    EstimatePlot::Condition condition{exponent > 0.9 ? "ppc" : "gc", {}, EstimatePlot::Law{exponent, 1.5, 1.4}};
    for (int i = 0; i < 200; ++i) {
      const double truth = 1.5 * std::pow(8, numbers.uniform());
      condition.points.push_back({truth, std::exp(1.4 + exponent * (std::log(truth) - 1.5) + 0.25 * numbers.normal())});
    }
    plot.conditions.push_back(std::move(condition));
  }
  return plot;
}

RosePlot sampleRoses() {
  SampleNumbers numbers(22);
  RosePlot plot;
  plot.title = "Errors of directions";
  for (const double spread : {20.0, 60.0}) {
    RosePlot::Condition condition{spread < 30 ? "ppc" : "gc", {}, {}, RosePlot::Vector{8, 0.85}, {{2, 14}}};
    for (int i = 0; i < 300; ++i) {
      condition.degrees.push_back(8 + spread * numbers.normal());
    }
    for (int i = 0; i < 20; ++i) {
      condition.subjects.push_back({8 + spread / 2 * numbers.normal(), 0.6 + 0.35 * numbers.uniform()});
    }
    plot.conditions.push_back(std::move(condition));
  }
  return plot;
}

PsychometricPlot samplePsychometric() {
  SampleNumbers numbers(23);
  PsychometricPlot plot;
  plot.title = "Right answers by level";
  plot.levelLabel = "Difference of distances (share)";
  plot.guess = 0.5;
  for (const double threshold : {0.1, 0.2}) {
    PsychometricPlot::Condition condition{
        threshold < 0.15 ? "ppc" : "gc", {}, {}, Interval{threshold, 0.8 * threshold, 1.3 * threshold}};
    for (int i = 0; i < 10; ++i) {
      const double level = 0.02 * std::pow(1.5, i);
      const double share = 0.5 + 0.48 / (1 + std::pow(threshold / level, 3));
      condition.curve.push_back({level, share});
      condition.points.push_back({level, std::clamp(share + 0.05 * numbers.normal(), 0.0, 1.0), 10 + 12 * (i % 4)});
    }
    plot.conditions.push_back(std::move(condition));
  }
  return plot;
}

GroupPlot sampleAccuracy() {
  SampleNumbers numbers(5);
  GroupPlot plot;
  plot.title = "Counting: right answers by condition";
  plot.valueLabel = "Right answers";
  plot.conditions = {"5 s", "10 s", "20 s", "duplicates", "no duplicates"};
  plot.percent = true;
  plot.reference = 0.25;
  plot.referenceName = "chance";
  plot.widthMillimetres = kDoubleColumnMillimetres;
  plot.series = {{"ppc", {}}, {"gc", {}}};
  for (const double share : {0.41, 0.38, 0.56, 0.41, 0.46}) {
    for (size_t s = 0; s < 2; ++s) {
      GroupValues values;
      values.raw = shares(numbers, 30, s == 0 ? share : 0.9);
      values.summary = shareOf(values.raw);
      plot.series[s].groups.push_back(values);
    }
  }
  return plot;
}

GroupPlot sampleStrip() {
  SampleNumbers numbers(6);
  GroupPlot plot;
  plot.title = "Detour against the shortest path by group";
  plot.valueLabel = "Path length / shortest path";
  plot.conditions = {"came once", "came twice", "came three times"};
  plot.styleByCondition = true;
  plot.scale = AxisScale::kLog;
  plot.pointName = "one trial";
  plot.series = {{"", {}}};
  for (const size_t count : {size_t{12}, size_t{40}, size_t{160}}) {
    GroupValues values;
    for (size_t i = 0; i < count; ++i) {
      values.raw.push_back(1 + 0.8 * std::exp(0.7 * numbers.normal()));
    }
    values.summary = meanOf(values.raw);
    plot.series[0].groups.push_back(values);
  }
  return plot;
}

PairedPlot samplePaired() {
  SampleNumbers numbers(7);
  PairedPlot plot;
  plot.conditions = {"ppc", "gc"};
  plot.title = "Finding: mean times of each subject";
  plot.valueLabel = "Time to find (s)";
  plot.summaryName = "geometric mean, 95 % interval";
  plot.scale = AxisScale::kLog;
  std::vector<double> first;
  std::vector<double> second;
  for (int i = 0; i < 36; ++i) {
    const double own = std::exp(0.3 * numbers.normal());
    first.push_back(19 * own * std::exp(0.15 * numbers.normal()));
    second.push_back(12.5 * own * std::exp(0.15 * numbers.normal()));
    plot.pairs.push_back({first.back(), second.back()});
  }
  plot.summaries = {meanOf(first), meanOf(second)};
  return plot;
}

RatingPlot sampleRatings() {
  RatingPlot plot;
  plot.title = "Survey: which view was easier";
  plot.lowest = "pinhole easier";
  plot.highest = "graph camera easier";
  plot.questions = {
      {"Finding objects", {0, 1, 2, 15, 27}, 4.51},
      {"Counting objects", {0, 0, 0, 1, 44}, 4.98},
      {"Matching paths: which of the two was easier to keep one's bearings in?", {8, 12, 14, 7, 4}, 2.71}};
  return plot;
}

/// Seven steps of a question that does not compare the views, and four without a middle that do, the other way round.
RatingPlot sampleSevenSteps() {
  RatingPlot plot;
  plot.title = "Survey: how tired";
  plot.steps = {"1", "2", "3", "4", "5", "6", "7"};
  plot.lowest = "not at all";
  plot.highest = "very";
  plot.parted = false;
  plot.questions = {{"Before", {20, 10, 5, 4, 3, 2, 1}, 2.3}, {"After", {1, 2, 4, 8, 10, 12, 8}, 5.0}};
  return plot;
}

RatingPlot sampleFourSteps() {
  RatingPlot plot;
  plot.title = "Survey: which view next time";
  plot.steps = {"1", "2", "3", "4"};
  plot.lowest = "surely the bent view";
  plot.highest = "surely the plain view";
  plot.lastIsOther = false;
  plot.questions = {{"Next time", {18, 12, 9, 6}, 2.07}};
  return plot;
}

HistogramPlot sampleErrors() {
  HistogramPlot plot;
  plot.title = "Counting: signed errors";
  plot.series = {{"ppc", {{-3, 8}, {-2, 31}, {-1, 90}, {0, 196}, {1, 77}, {2, 38}, {3, 9}, {20, 1}}},
                 {"gc", {{-2, 4}, {-1, 22}, {0, 406}, {1, 15}, {2, 3}}}};
  return plot;
}

ModelCheckPlot sampleCheck() {
  SampleNumbers numbers(8);
  ModelCheckPlot plot;
  plot.title = "Model of log times: residuals";
  plot.fittedLabel = "Fitted log time";
  plot.residualLabel = "Standardised residual";
  for (int i = 0; i < 400; ++i) {
    plot.fitted.push_back(2.5 + 0.5 * numbers.normal());
    plot.residuals.push_back(numbers.normal() + (numbers.uniform() < 0.02 ? 3 : 0));
  }
  return plot;
}

PowerPlot samplePower() {
  PowerPlot plot;
  plot.title = "Power of the find task";
  for (const double effect : {0.7, 0.8, 0.9}) {
    PowerPlot::Curve curve{fmt::format("ratio {:.1f}", effect), {}};
    for (const double n : {6.0, 12.0, 18.0, 24.0, 36.0, 48.0}) {
      const double power = 0.025 + 0.975 / (1 + std::exp(-(std::sqrt(n) * -std::log(effect) * 4.2 - 2)));
      const double half = 1.96 * std::sqrt(power * (1 - power) / 400);
      curve.points.push_back({n, {power, power - half, std::min(1.0, power + half)}});
    }
    plot.curves.push_back(curve);
  }
  return plot;
}

FlowDiagram sampleFlow() {
  FlowDiagram diagram;
  diagram.title = "Subjects";
  diagram.stages = {{"Consented",
                     47,
                     "subjects",
                     {{"became motion sick about ten minutes into the first session", 1}, {"visual impairment", 1}}},
                    {"Analysed: first session", 45, "subjects", {{"did not come again", 12}}},
                    {"Second session", 33, "subjects", {{"did not come again", 8}}},
                    {"Completed all three sessions", 25}};
  return diagram;
}

}  // namespace

double SampleNumbers::uniform() {
  // splitmix64
  uint64_t z = (state_ += 0x9E3779B97F4A7C15ULL);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

double SampleNumbers::normal() {
  const double radius = std::sqrt(-2 * std::log(1 - uniform()));
  return radius * std::cos(2 * std::numbers::pi * uniform());
}

GroupPlot sampleLearning() {
  SampleNumbers numbers(1);
  GroupPlot plot;
  plot.title = "Finding: times over sessions";
  plot.conditionLabel = "Session";
  plot.valueLabel = "Time to find (s)";
  plot.conditions = {"1", "2", "3"};
  plot.connected = true;
  plot.linked = true;
  plot.series = {{"ppc", {}}, {"gc", {}}};
  std::vector<double> own;
  for (int i = 0; i < 25; ++i) {
    own.push_back(std::exp(0.2 * numbers.normal()));
  }
  for (size_t s = 0; s < 2; ++s) {
    for (const double mean : s == 0 ? std::vector{19.7, 15.7, 14.3} : std::vector{12.9, 10.9, 9.2}) {
      GroupValues values;
      for (const double factor : own) {
        values.raw.push_back(mean * factor * std::exp(0.1 * numbers.normal()));
      }
      values.summary = meanOf(values.raw);
      plot.series[s].groups.push_back(values);
    }
  }
  return plot;
}

GroupPlot sampleCases() {
  SampleNumbers numbers(2);
  GroupPlot plot;
  plot.title = "Finding: times of each case";
  plot.conditionLabel = "";
  plot.valueLabel = "Time to find (s)";
  plot.pointName = "one trial";
  plot.rows = true;
  plot.widthMillimetres = kDoubleColumnMillimetres;
  plot.series = {{"ppc", {}}, {"gc", {}}};
  for (int c = 1; c <= 12; ++c) {
    plot.conditions.push_back(fmt::format("Case {}", c));
    for (size_t s = 0; s < 2; ++s) {
      GroupValues values;
      values.raw = times(numbers, 22, (s == 0 ? 20 : 13) * std::exp(0.4 * numbers.normal()));
      values.summary = meanOf(values.raw);
      plot.series[s].groups.push_back(values);
    }
  }
  return plot;
}

SurvivalPlot sampleSurvival() {
  SampleNumbers numbers(3);
  SurvivalPlot plot;
  plot.title = "Finding: still searching";
  plot.timeLabel = "Time since the start (s)";
  plot.riskTimes = {0, 10, 20, 30, 40, 50, 60};
  for (const auto& [name, median] : {std::pair{"ppc", 21.0}, std::pair{"gc", 11.0}}) {
    SurvivalPlot::Curve curve;
    curve.name = name;
    std::vector<std::pair<double, bool>> ends;  // and whether it was found
    for (int i = 0; i < 120; ++i) {
      const double time = median * std::exp(0.8 * numbers.normal());
      const double leaves = numbers.uniform() < 0.08 ? 60 * numbers.uniform() : 60;
      ends.emplace_back(std::min(time, leaves), time <= leaves);
    }
    std::sort(ends.begin(), ends.end());
    double survival = 1;
    double sum = 0;
    for (size_t i = 0; i < ends.size(); ++i) {
      const auto atRisk = static_cast<double>(ends.size() - i);
      if (ends[i].second) {
        survival *= 1 - 1 / atRisk;
        sum += atRisk > 1 ? 1 / (atRisk * (atRisk - 1)) : 0;
        const double error = survival * std::sqrt(sum);
        curve.steps.push_back(
            {ends[i].first, survival, std::max(0.0, survival - 1.96 * error), std::min(1.0, survival + 1.96 * error)});
      } else {
        curve.censoredTimes.push_back(ends[i].first);
      }
    }
    for (const double time : plot.riskTimes) {
      curve.atRisk.push_back(static_cast<size_t>(
          std::count_if(ends.begin(), ends.end(), [&](const auto& end) { return end.first >= time; })));
    }
    plot.curves.push_back(curve);
  }
  return plot;
}

ForestPlot sampleForest() {
  ForestPlot plot;
  plot.title = "Finding: ratio of times and its sensitivity";
  plot.valueLabel = "Ratio of times, gc / ppc";
  plot.lowerSide = "gc faster";
  plot.upperSide = "ppc faster";
  plot.ratio = true;
  plot.rows = {{"Main result", {}, true},
               {"Mixed model, log time", {0.66, 0.58, 0.75}, false, true},
               {"Sensitivity", {}, true},
               {"Time-outs removed", {0.69, 0.61, 0.78}},
               {"Time-outs set to the limit", {0.64, 0.55, 0.74}},
               {"First exposure only", {0.71, 0.52, 0.97}},
               {"Without case 3", {0.68, 0.59, 0.78}},
               {"Moving objects only, subjects of one session", {0.9, 0.05, 31}},
               {"Trials with dropped frames removed", {kNaN, kNaN, kNaN}, false, false, "no frames recorded"}};
  return plot;
}

FigureGrid sampleGrid() {
  FigureGrid grid;
  grid.title = "Learning: times, and times again";
  for (GroupPlot plot : {sampleLearning(), sampleLearning(), sampleStrip()}) {
    plot.legend = false;
    plot.widthMillimetres = grid.columnMillimetres();
    grid.legend = groupLegend(sampleLearning());
    grid.figures.push_back(groupFigure(plot));
  }
  return grid;
}

HeatMap sampleHeat() {
  SampleNumbers numbers(4);
  HeatMap map;
  map.title = "Where subjects were";
  map.valueLabel = "Share of the time in the maze";
  map.percent = true;
  map.rootScale = true;
  for (const char* name : {"ppc", "gc"}) {
    HeatMap::Map each;
    each.name = name;
    for (int x = 0; x < 16; ++x) {
      for (int y = 0; y < 12; ++y) {
        if ((x * 7 + y * 5) % 11 != 0) {
          const double near = std::exp(-0.12 * (std::hypot(x - 3, y - 9)));
          each.cells.push_back({x + 0.5, y + 0.5, 0.05 * near * near * (0.5 + numbers.uniform())});
        }
      }
    }
    each.marks = {{3.5, 9.5, "start"}, {14.5, 2.5, "object"}};
    map.maps.push_back(each);
  }
  map.walls = {{0, 0, 16, 0}, {16, 0, 16, 12}, {16, 12, 0, 12}, {0, 12, 0, 0},
               {4, 0, 4, 7},  {8, 5, 8, 12},   {12, 0, 12, 8},  {4, 7, 6, 7}};
  return map;
}

TradeOffPlot sampleTradeOff() {
  TradeOffPlot plot;
  plot.title = "Counting: speed against accuracy";
  plot.timeLabel = "Time to answer (s)";
  plot.shareLabel = "Share of right answers";
  plot.conditions = {{"pinhole camera", {}, {}}, {"graph camera", {}, {}}, {"top view", {}, {}}};
  SampleNumbers numbers(17);
  for (size_t i = 0; i < plot.conditions.size(); ++i) {
    TradeOffPlot::Condition& condition = plot.conditions[i];
    for (int subject = 0; subject < 24; ++subject) {
      const double seconds = std::exp(0.6 + 0.3 * static_cast<double>(i) + 0.3 * numbers.normal());
      const double share = std::clamp(0.6 + 0.12 * static_cast<double>(i) + 0.12 * numbers.normal(), 0.0, 1.0);
      condition.subjects.push_back({seconds, share});
      condition.mean.seconds += std::log(seconds) / 24;
      condition.mean.share += share / 24;
    }
    condition.mean.seconds = std::exp(condition.mean.seconds);
  }
  return plot;
}

std::vector<SampleFigure> sampleFigures() {
  return {{"learning", groupFigure(sampleLearning())},
          {"cases", groupFigure(sampleCases())},
          {"accuracy", groupFigure(sampleAccuracy())},
          {"strip", groupFigure(sampleStrip())},
          {"paired", pairedFigure(samplePaired())},
          {"trade-off", tradeOffFigure(sampleTradeOff())},
          {"estimates", estimateFigure(sampleEstimates())},
          {"roses", roseFigure(sampleRoses())},
          {"psychometric", psychometricFigure(samplePsychometric())},
          {"survival", survivalFigure(sampleSurvival())},
          {"ratings", ratingFigure(sampleRatings())},
          {"ratings-7", ratingFigure(sampleSevenSteps())},
          {"ratings-4", ratingFigure(sampleFourSteps())},
          {"forest", forestFigure(sampleForest())},
          {"errors", histogramFigure(sampleErrors())},
          {"heat", heatFigure(sampleHeat())},
          {"check", modelCheckFigure(sampleCheck())},
          {"power", powerFigure(samplePower())},
          {"flow", flowFigure(sampleFlow())},
          {"grid", gridFigure(sampleGrid())}};
}

std::vector<SampleFigure> emptyFigures() {
  const std::string title = "Nothing";
  GroupPlot group;
  group.title = title;
  PairedPlot paired;
  paired.conditions = {"ppc", "gc"};
  paired.title = title;
  SurvivalPlot survival;
  survival.title = title;
  RatingPlot rating;
  rating.title = title;
  rating.questions = {{"Nobody answered", {0, 0, 0, 0, 0}}};
  ForestPlot forest;
  forest.title = title;
  HistogramPlot histogram;
  histogram.title = title;
  HeatMap heat;
  heat.title = title;
  ModelCheckPlot check;
  check.title = title;
  PowerPlot power;
  power.title = title;
  TradeOffPlot tradeOff;
  tradeOff.title = title;
  EstimatePlot estimates;
  estimates.title = title;
  RosePlot roses;
  roses.title = title;
  PsychometricPlot psychometric;
  psychometric.title = title;
  FlowDiagram flow;
  flow.title = title;
  FigureGrid grid;
  grid.title = title;
  return {{"group", groupFigure(group)},
          {"paired", pairedFigure(paired)},
          {"survival", survivalFigure(survival)},
          {"ratings", ratingFigure(rating)},
          {"forest", forestFigure(forest)},
          {"errors", histogramFigure(histogram)},
          {"heat", heatFigure(heat)},
          {"check", modelCheckFigure(check)},
          {"power", powerFigure(power)},
          {"flow", flowFigure(flow)},
          {"grid", gridFigure(grid)},
          {"trade-off", tradeOffFigure(tradeOff)},
          {"estimates", estimateFigure(estimates)},
          {"roses", roseFigure(roses)},
          {"psychometric", psychometricFigure(psychometric)}};
}

std::vector<SampleFigure> tinyFigures() {
  GroupPlot group;
  group.title = "One value";
  group.valueLabel = "Time (s)";
  group.conditions = {"1"};
  group.series = {{"ppc", {{{7, kNaN, kNaN}, {7, kNaN}}}}, {"gc", {{{kNaN, kNaN, kNaN}, {}}}}};
  PairedPlot paired;
  paired.conditions = {"ppc", "gc"};
  paired.title = "One pair";
  paired.pairs = {{5, 5}, {kNaN, 3}};
  paired.summaries = {{{kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}}};
  SurvivalPlot survival;
  survival.title = "Censored alone";
  survival.curves = {{"ppc", {}, {60, 60}, {}}, {"gc", {}, {}, {}}};
  RatingPlot rating;
  rating.title = "One answer";
  rating.questions = {{"Which?", {0, 0, 1, 0, 0}, 3}};
  ForestPlot forest;
  forest.title = "One estimate";
  forest.rows = {{"a", {0.2, kNaN, kNaN}}, {"b", {0, 0, 0}}};
  HistogramPlot histogram;
  histogram.title = "One answer";
  histogram.series = {{"ppc", {{0, 1}}}, {"gc", {}}};
  HeatMap heat;
  heat.title = "One cell";
  heat.maps = {{"ppc", {{0, 0, 0}}, {}}, {"gc", {{1, 0, kNaN}}, {}}};
  ModelCheckPlot check;
  check.title = "One residual";
  check.fitted = {1};
  check.residuals = {0};
  PowerPlot power;
  power.title = "One number";
  power.curves = {{"a", {{10, {0.5, kNaN, kNaN}}}}};
  TradeOffPlot tradeOff;
  tradeOff.title = "One subject";
  tradeOff.conditions = {{"a", {{3, 1}}, {3, 1}}, {"b", {{kNaN, kNaN}}, {kNaN, kNaN}}};
  EstimatePlot estimates;
  estimates.title = "One estimate";
  estimates.unit = "metres";
  estimates.conditions = {{"a", {{3, 2}, {0, 1}, {kNaN, 1}}, EstimatePlot::Law{0.5, 1, 0.7}}, {"b", {}}};
  RosePlot roses;
  roses.title = "One direction";
  roses.conditions = {{"a", {-180, kNaN}, {{180, 1}}, RosePlot::Vector{180, 1}, {{150, 210}}}, {"b", {}}};
  PsychometricPlot psychometric;
  psychometric.title = "One level";
  psychometric.conditions = {{"a", {{1, 0.5, 2}, {kNaN, kNaN, 0}}, {}, Interval{1e-9, kNaN, 1e9}}, {"b", {}}};
  FlowDiagram flow;
  flow.title = "One stage";
  flow.stages = {{"Consented", 1, "subject", {{"left", 1}}}};
  return {{"group", groupFigure(group)},
          {"paired", pairedFigure(paired)},
          {"survival", survivalFigure(survival)},
          {"ratings", ratingFigure(rating)},
          {"forest", forestFigure(forest)},
          {"errors", histogramFigure(histogram)},
          {"heat", heatFigure(heat)},
          {"check", modelCheckFigure(check)},
          {"power", powerFigure(power)},
          {"flow", flowFigure(flow)},
          {"trade-off", tradeOffFigure(tradeOff)},
          {"estimates", estimateFigure(estimates)},
          {"roses", roseFigure(roses)},
          {"psychometric", psychometricFigure(psychometric)}};
}

}  // namespace ocelli
