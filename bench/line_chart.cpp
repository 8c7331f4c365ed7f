#include "bench/line_chart.h"

#include <fmt/format.h>

#include "analysis/plot/chart_text.h"
#include "analysis/plot/panel.h"

namespace ocelli {

Figure lineFigure(const LineChart& chart) {
  constexpr double kPanelHeight = 240;
  constexpr double kWidth = 440;
  std::vector<double> xs;
  std::vector<double> ys;
  std::vector<LegendEntry> entries;
  for (size_t i = 0; i < chart.curves.size(); ++i) {
    entries.push_back({chart.curves[i].name, seriesStyle(i), true, true});
    for (const PlotPoint& point : chart.curves[i].points) {
      xs.push_back(point.x);
      ys.push_back(point.y);
    }
  }
  Figure figure{chart.title, fmt::format("{} by {}.", chart.yLabel, chart.xLabel), kWidth, 0, {}};
  const double legend = drawLegend(figure.drawing, {0, 0, figure.width, 0}, entries);
  figure.height = legend + kPanelHeight;
  const Panel panel(figure.drawing, {0, legend, figure.width - 8, figure.height},
                    AxisSpec::ofValues(chart.xLabel, AxisRange::of(xs, AxisScale::kLog), false),
                    AxisSpec::ofValues(chart.yLabel, AxisRange::of(ys, AxisScale::kLog)));
  for (size_t i = 0; i < chart.curves.size(); ++i) {
    const SeriesStyle style = seriesStyle(i);
    std::vector<PlotPoint> line;
    figure.description += fmt::format(" {}:", chart.curves[i].name);
    for (const PlotPoint& point : chart.curves[i].points) {
      line.push_back(panel.at(point.x, point.y));
      figure.description += fmt::format(" {:.3g} at {:.3g};", point.y, point.x);
      drawUprightInterval(figure.drawing, panel, panel.x(point.x), {point.y, point.y, point.y}, style);
    }
    if (line.size() > 1) {
      figure.drawing.polyline("curve", line, {style.paint, kThickLine, style.dash});
    }
  }
  return figure;
}

}  // namespace ocelli
