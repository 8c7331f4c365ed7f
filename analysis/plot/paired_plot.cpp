#include "analysis/plot/paired_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/plot/chart_text.h"

namespace ocelli {
namespace {

constexpr double kPairedHeight = 190;
// The two columns of dots stand at 0 and 1; their summaries outside.
constexpr double kSummaryAway = 0.2;

}  // namespace

Figure pairedFigure(const PairedPlot& plot) {
  std::vector<PairedPlot::Pair> pairs;
  std::vector<double> values;
  for (const PairedPlot::Pair& pair : plot.pairs) {
    if (isDrawable(pair.first, plot.scale) && isDrawable(pair.second, plot.scale)) {
      pairs.push_back(pair);
      values.insert(values.end(), {pair.first, pair.second});
    }
  }
  if (pairs.empty()) {
    return emptyFigure(plot.title, plot.widthMillimetres,
                       fmt::format("no subject has values for both {} and {}", plot.conditions[0], plot.conditions[1]));
  }
  for (const Interval& summary : plot.summaries) {
    values.insert(values.end(), {summary.value, summary.lower, summary.upper});
  }
  AxisRange range = AxisRange::of(values, plot.scale);
  if (plot.scale == AxisScale::kLinear && (plot.fromZero || plot.percent)) {
    range = range.with(0);
  }
  range.percent = plot.percent;

  const auto more =
      std::count_if(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.second > pair.first; });
  const auto same =
      std::count_if(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.second == pair.first; });
  Figure figure{plot.title, "", plot.widthMillimetres * kPointsPerMillimetre, kPairedHeight, {}};
  figure.description = fmt::format(
      "{} of {} subjects, {} against {}. {}: {} {}; {} {}. The value is higher with {} for {} subjects, lower for {}, "
      "the same for {}.",
      plot.valueLabel, pairs.size(), plot.conditions[0], plot.conditions[1], plot.summaryName, plot.conditions[0],
      intervalText(plot.summaries[0], plot.percent), plot.conditions[1], intervalText(plot.summaries[1], plot.percent),
      plot.conditions[1], more, static_cast<std::ptrdiff_t>(pairs.size()) - more - same, same);
  if (pairs.size() < plot.pairs.size()) {
    figure.description +=
        fmt::format(" {} subjects without a value for both are not shown.", plot.pairs.size() - pairs.size());
  }

  const SeriesStyle neutral{kSoftTextPaint, Marker::kCircle, {}};
  const double legend =
      drawLegend(figure.drawing, {0, 0, figure.width, 0},
                 {{plot.summaryName, neutral, true, true},
                  {plot.pointName, {kSoftTextPaint.faded(0.5), Marker::kCircle, {}}, true, false, true, kPointRadius}});
  const Panel panel(figure.drawing, {0, legend, figure.width, kPairedHeight},
                    AxisSpec::ofCategories("", {plot.conditions[0], plot.conditions[1]}),
                    AxisSpec::ofValues(plot.valueLabel, range));
  const double opacity = pointOpacity(pairs.size());
  for (const PairedPlot::Pair& pair : pairs) {
    figure.drawing.line("link", panel.at(0, pair.first), panel.at(1, pair.second),
                        {kSoftTextPaint.faded(0.8 * opacity), kThinLine});
  }
  for (const PairedPlot::Pair& pair : pairs) {
    for (const size_t side : {size_t{0}, size_t{1}}) {
      const SeriesStyle style = seriesStyle(side);
      figure.drawing.marker("point",
                            {panel.at(static_cast<double>(side), side == 0 ? pair.first : pair.second), style.marker,
                             kPointRadius, style.paint.faded(std::min(2 * opacity, 0.8)), std::nullopt});
    }
  }
  for (const size_t side : {size_t{0}, size_t{1}}) {
    const double x = panel.x(side == 0 ? -kSummaryAway : 1 + kSummaryAway);
    drawUprightInterval(figure.drawing, panel, x, plot.summaries[side], seriesStyle(side));
  }
  return figure;
}

}  // namespace ocelli
