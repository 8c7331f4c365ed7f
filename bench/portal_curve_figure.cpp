#include "bench/portal_curve_figure.h"

#include <fmt/format.h>

#include "analysis/plot/chart_text.h"
#include "analysis/plot/panel.h"

namespace ocelli {
namespace {

constexpr double kFarthestCells = 8;
constexpr int kPointsOfCurve = 321;

}  // namespace

double shareAhead(const PortalOptions& options, double cells) {
  const Portal opening{{0, 1.2f, 0}, {1, 0, 0}, {0, 0, -1.35f}, {0, 1.2f, 0}};
  return portalShare(opening, glm::dvec3(1.35, 1.5, cells * 3), options);
}

Figure portalCurveFigure(const std::vector<NamedPortalCurve>& curves) {
  constexpr double kPanelHeight = 200;
  constexpr double kWidth = 440;
  std::vector<LegendEntry> entries;
  for (size_t i = 0; i < curves.size(); ++i) {
    entries.push_back({curves[i].name, seriesStyle(i), true, false});
  }
  Figure figure{"How much rays turn in the side openings of a corridor",
                "Per cent of the way from straight to along the normal, by cells of 3 m to the opening.",
                kWidth,
                0,
                {}};
  const double legend = drawLegend(figure.drawing, {0, 0, figure.width, 0}, entries);
  figure.height = legend + kPanelHeight;
  const Panel panel(figure.drawing, {0, legend, figure.width - 8, figure.height},
                    AxisSpec::ofValues("cells ahead", AxisRange::of({0, kFarthestCells}, AxisScale::kLinear), false),
                    AxisSpec::ofValues("rays turn by, %", AxisRange::of({0, 100}, AxisScale::kLinear)));
  for (size_t i = 0; i < curves.size(); ++i) {
    const SeriesStyle style = seriesStyle(i);
    std::vector<PlotPoint> line;
    for (int k = 0; k < kPointsOfCurve; ++k) {
      const double cells = kFarthestCells * k / (kPointsOfCurve - 1);
      line.push_back(panel.at(cells, 100 * shareAhead(curves[i].options, cells)));
    }
    figure.drawing.polyline("curve", line, {style.paint, kThickLine, style.dash});
    figure.description += fmt::format(" {}:", curves[i].name);
    for (int cells = 1; cells <= static_cast<int>(kFarthestCells); ++cells) {
      figure.description += fmt::format(" {:.0f} at {};", 100 * shareAhead(curves[i].options, cells), cells);
    }
  }
  return figure;
}

}  // namespace ocelli
