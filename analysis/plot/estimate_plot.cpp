#include "analysis/plot/estimate_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/plot/chart_text.h"
#include "analysis/plot/figure_grid.h"
#include "analysis/plot/swarm.h"

namespace ocelli {
namespace {

constexpr double kPanelHeight = 190;

bool canDrawEstimate(const EstimatePlot::Point& point) {
  return isDrawable(point.truth, AxisScale::kLog) && isDrawable(point.estimate, AxisScale::kLog);
}

/// Evenly by rank of the estimate where there are very many.
std::vector<EstimatePlot::Point> drawnOf(const EstimatePlot::Condition& condition) {
  std::vector<EstimatePlot::Point> points;
  std::copy_if(condition.points.begin(), condition.points.end(), std::back_inserter(points), canDrawEstimate);
  std::vector<double> estimates;
  for (const EstimatePlot::Point& point : points) {
    estimates.push_back(point.estimate);
  }
  std::vector<EstimatePlot::Point> drawn;
  for (const size_t i : drawnPoints(estimates, kMaxPoints)) {
    drawn.push_back(points[i]);
  }
  return drawn;
}

Figure panelOf(const EstimatePlot& plot, const EstimatePlot::Condition& condition, const SeriesStyle& style,
               const AxisRange& truths, const AxisRange& estimates, double width) {
  Figure figure{condition.name, "", width * kPointsPerMillimetre, kPanelHeight, {}};
  const std::vector<EstimatePlot::Point> points = drawnOf(condition);
  const auto far =
      std::count_if(points.begin(), points.end(), [](const auto& each) { return each.estimate > each.truth; });
  figure.description = fmt::format("{} estimates are drawn, {} of them above the truth", points.size(), far);
  const Panel panel(figure.drawing, {0, 0, figure.width, kPanelHeight},
                    AxisSpec::ofValues(fmt::format("Truth ({})", plot.unit), truths),
                    AxisSpec::ofValues(fmt::format("Estimate ({})", plot.unit), estimates));
  const double low = std::max(panel.xAxis().low(), panel.yAxis().low());
  const double high = std::min(panel.xAxis().high(), panel.yAxis().high());
  if (low < high) {
    figure.drawing.line("reference", panel.at(low, low), panel.at(high, high), {kReferencePaint, kLine, {3, 2}});
  }
  const double opacity = pointOpacity(points.size());
  for (const EstimatePlot::Point& point : points) {
    figure.drawing.marker("point", {panel.at(point.truth, point.estimate), style.marker, kPointRadius,
                                    style.paint.faded(opacity), std::nullopt});
  }
  if (condition.law && !points.empty()) {
    const auto [first, last] = std::minmax_element(points.begin(), points.end(),
                                                   [](const auto& a, const auto& b) { return a.truth < b.truth; });
    const EstimatePlot::Law& law = *condition.law;
    const auto at = [&](double truth) {
      const double estimate = std::exp(law.logAtCenter + law.exponent * (std::log(truth) - law.logCenter));
      return panel.at(truth, std::clamp(estimate, panel.yAxis().low(), panel.yAxis().high()));
    };
    figure.drawing.line("law", at(first->truth), at(last->truth), {kWhite, kThickLine + 1.6});
    figure.drawing.line("law", at(first->truth), at(last->truth), {style.paint, kThickLine});
    figure.description += fmt::format("; the power law has the exponent {:.2f}", law.exponent);
  }
  figure.description += '.';
  return figure;
}

}  // namespace

Figure estimateFigure(const EstimatePlot& plot) {
  std::vector<double> truths;
  std::vector<double> estimates;
  for (const EstimatePlot::Condition& condition : plot.conditions) {
    for (const EstimatePlot::Point& point : condition.points) {
      if (canDrawEstimate(point)) {
        truths.push_back(point.truth);
        estimates.push_back(point.estimate);
      }
    }
  }
  if (truths.empty()) {
    return emptyFigure(plot.title, kDoubleColumnMillimetres, "no trial holds an estimate");
  }
  FigureGrid grid;
  grid.title = plot.title;
  const AxisRange truthRange = AxisRange::of(truths, AxisScale::kLog);
  const AxisRange estimateRange = AxisRange::of(estimates, AxisScale::kLog);
  for (size_t i = 0; i < plot.conditions.size(); ++i) {
    grid.figures.push_back(
        panelOf(plot, plot.conditions[i], seriesStyle(i), truthRange, estimateRange, grid.columnMillimetres()));
  }
  return gridFigure(grid);
}

}  // namespace ocelli
