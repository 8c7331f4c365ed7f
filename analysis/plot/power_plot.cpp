#include "analysis/plot/power_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/plot/chart_text.h"

namespace ocelli {
namespace {

constexpr double kPowerPanelHeight = 165;

std::vector<PowerPlot::Point> drawablePoints(const PowerPlot::Curve& curve) {
  std::vector<PowerPlot::Point> points;
  for (const PowerPlot::Point& point : curve.points) {
    if (std::isfinite(point.subjects) && std::isfinite(point.power.value)) {
      points.push_back(point);
    }
  }
  std::stable_sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.subjects < b.subjects; });
  return points;
}

}  // namespace

Figure powerFigure(const PowerPlot& plot) {
  std::vector<double> subjects;
  for (const PowerPlot::Curve& curve : plot.curves) {
    for (const PowerPlot::Point& point : drawablePoints(curve)) {
      subjects.push_back(point.subjects);
    }
  }
  if (subjects.empty()) {
    return emptyFigure(plot.title, plot.widthMillimetres, "no number of subjects was simulated");
  }
  Figure figure{plot.title,
                fmt::format("{} by {}.", plot.powerLabel, plot.subjectsLabel),
                plot.widthMillimetres * kPointsPerMillimetre,
                0,
                {}};
  std::vector<LegendEntry> entries;
  for (size_t i = 0; i < plot.curves.size(); ++i) {
    entries.push_back({plot.curves[i].name, seriesStyle(i), true, true});
  }
  const double legend = drawLegend(figure.drawing, {0, 0, figure.width, 0}, entries);
  figure.height = legend + kPowerPanelHeight;
  AxisRange x = AxisRange::of(subjects).with(0);
  x.whole = true;
  AxisRange y;
  y.percent = true;
  const Panel panel(figure.drawing, {0, legend, figure.width - 4, figure.height},
                    AxisSpec::ofValues(plot.subjectsLabel, x, false), AxisSpec::ofValues(plot.powerLabel, y));
  const double target = panel.y(plot.target);
  figure.drawing.line("reference", {panel.area().left, target}, {panel.area().right, target},
                      {kReferencePaint, kLine, {3, 2}});
  for (size_t i = 0; i < plot.curves.size(); ++i) {
    const std::vector<PowerPlot::Point> points = drawablePoints(plot.curves[i]);
    const SeriesStyle style = seriesStyle(i);
    std::vector<PlotPoint> line;
    for (const PowerPlot::Point& point : points) {
      line.push_back(panel.at(point.subjects, point.power.value));
    }
    if (line.size() > 1) {
      figure.drawing.polyline("curve", line, {style.paint, kThickLine, style.dash});
    }
    figure.description += fmt::format(" {}:", plot.curves[i].name);
    for (const PowerPlot::Point& point : points) {
      drawUprightInterval(figure.drawing, panel, panel.x(point.subjects), point.power, style);
      figure.description += fmt::format(" {} at {};", intervalText(point.power, true), numberText(point.subjects, 0));
    }
    const auto enough =
        std::find_if(points.begin(), points.end(), [&](const auto& point) { return point.power.value >= plot.target; });
    figure.description += enough == points.end() ? fmt::format(" {} is not reached.", percentText(plot.target))
                                                 : fmt::format(" {} is reached at {}.", percentText(plot.target),
                                                               numberText(enough->subjects, 0));
  }
  return figure;
}

}  // namespace ocelli
