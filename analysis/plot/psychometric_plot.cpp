#include "analysis/plot/psychometric_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/plot/chart_text.h"
#include "analysis/plot/figure_grid.h"

namespace ocelli {
namespace {

constexpr double kPanelOfLevelsHeight = 175;
constexpr double kLargestDot = 5;
constexpr double kSmallestDot = 1.2;
/// Where the interval of the threshold stands, as a share above the axis.
constexpr double kThresholdShare = 0.04;

Figure levelPanel(const PsychometricPlot& plot, const PsychometricPlot::Condition& condition, const SeriesStyle& style,
                  const AxisRange& levels, int mostTrials, double width) {
  Figure figure{condition.name, "", width * kPointsPerMillimetre, kPanelOfLevelsHeight, {}};
  AxisRange shares = AxisRange::of({0, 1});
  shares.percent = true;
  const Panel panel(figure.drawing, {0, 0, figure.width, kPanelOfLevelsHeight},
                    AxisSpec::ofValues(plot.levelLabel, levels), AxisSpec::ofValues("Right answers", shares));
  if (plot.guess > 0) {
    figure.drawing.line("reference", panel.at(panel.xAxis().low(), plot.guess),
                        panel.at(panel.xAxis().high(), plot.guess), {kReferencePaint, kLine, {3, 2}});
  }
  int trials = 0;
  for (const PsychometricPlot::Point& point : condition.points) {
    if (isDrawable(point.level, AxisScale::kLog) && isDrawable(point.share, AxisScale::kLinear)) {
      const double radius =
          std::max(kSmallestDot, kLargestDot * std::sqrt(point.trials / static_cast<double>(std::max(mostTrials, 1))));
      figure.drawing.marker("point", {panel.at(point.level, point.share), Marker::kCircle, radius,
                                      style.paint.faded(0.45), Pen{style.paint, kThinLine}});
      trials += point.trials;
    }
  }
  std::vector<PlotPoint> line;
  for (const PsychometricPlot::CurvePoint& point : condition.curve) {
    if (panel.xAxis().holds(point.level)) {
      line.push_back(panel.at(point.level, point.share));
    }
  }
  if (line.size() > 1) {
    figure.drawing.polyline("curve", line, {style.paint, kThickLine});
  }
  figure.description = fmt::format("{} trials at {} levels", trials, condition.points.size());
  if (condition.threshold) {
    Interval shown = *condition.threshold;
    const auto held = [&](double value) { return std::clamp(value, panel.xAxis().low(), panel.xAxis().high()); };
    shown.lower = held(shown.lower);
    shown.upper = held(shown.upper);
    if (panel.xAxis().holds(shown.value)) {
      drawLevelInterval(figure.drawing, panel, panel.y(kThresholdShare), shown, style);
    }
    figure.description += fmt::format("; threshold {}", intervalText(*condition.threshold));
  }
  figure.description += '.';
  return figure;
}

}  // namespace

Figure psychometricFigure(const PsychometricPlot& plot) {
  std::vector<double> levels;
  int most = 0;
  for (const PsychometricPlot::Condition& condition : plot.conditions) {
    for (const PsychometricPlot::Point& point : condition.points) {
      if (isDrawable(point.level, AxisScale::kLog)) {
        levels.push_back(point.level);
        most = std::max(most, point.trials);
      }
    }
  }
  if (levels.empty()) {
    return emptyFigure(plot.title, kDoubleColumnMillimetres, "no trial has a level");
  }
  FigureGrid grid;
  grid.title = plot.title;
  const AxisRange range = AxisRange::of(levels, AxisScale::kLog);
  for (size_t i = 0; i < plot.conditions.size(); ++i) {
    grid.figures.push_back(levelPanel(plot, plot.conditions[i], seriesStyle(i), range, most, grid.columnMillimetres()));
  }
  return gridFigure(grid);
}

}  // namespace ocelli
