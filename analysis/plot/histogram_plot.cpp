#include "analysis/plot/histogram_plot.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/plot/chart_text.h"

namespace ocelli {
namespace {

constexpr int kFarthest = 8;
constexpr double kHistogramHeight = 74;

size_t totalOf(const HistogramPlot::Series& series) {
  size_t total = 0;
  for (const auto& [value, count] : series.counts) {
    total += count;
  }
  return total;
}

/// With everything beyond the farthest gathered there.
std::map<int, size_t> gathered(const HistogramPlot::Series& series) {
  std::map<int, size_t> counts;
  for (const auto& [value, count] : series.counts) {
    counts[std::clamp(value, -kFarthest, kFarthest)] += count;
  }
  return counts;
}

std::string signedText(int value) {
  const std::string number = numberText(value, 0);
  return value > 0 ? fmt::format("+{}", number) : number;
}

}  // namespace

Figure histogramFigure(const HistogramPlot& plot) {
  int low = -2;
  int high = 2;
  double maxShare = 0;
  bool beyond = false;
  for (const HistogramPlot::Series& series : plot.series) {
    for (const auto& [value, count] : gathered(series)) {
      low = std::min(low, value);
      high = std::max(high, value);
      maxShare =
          std::max(maxShare, static_cast<double>(count) / static_cast<double>(std::max<size_t>(totalOf(series), 1)));
    }
    beyond = beyond || (!series.counts.empty() &&
                        (series.counts.begin()->first < -kFarthest || series.counts.rbegin()->first > kFarthest));
  }
  if (maxShare == 0) {
    return emptyFigure(plot.title, plot.widthMillimetres, "no count was answered");
  }
  AxisRange errors;
  errors.low = low - 0.5;
  errors.high = high + 0.5;
  errors.roundLow = false;
  errors.roundHigh = false;
  errors.whole = true;
  const std::string label =
      beyond ? fmt::format("{} (\u00b1{}: or more)", plot.valueLabel, kFarthest) : plot.valueLabel;
  Figure figure{plot.title,
                fmt::format("{}: how many answers were how far off.", plot.valueLabel),
                plot.widthMillimetres * kPointsPerMillimetre,
                0,
                {}};
  double top = 0;
  for (size_t s = 0; s < plot.series.size(); ++s) {
    const HistogramPlot::Series& series = plot.series[s];
    const bool last = s + 1 == plot.series.size();
    const double height = kHistogramHeight + (last ? kLineHeight + 2 : 0);
    AxisRange shares;
    shares.percent = true;
    shares.high = maxShare;
    const size_t total = totalOf(series);
    drawLegend(figure.drawing, {0, top, figure.width, top},
               {{fmt::format("{} (n = {})", series.name, numberText(static_cast<double>(total), 0)), seriesStyle(s)}});
    const Panel panel(figure.drawing, {0, top + 22, figure.width, top + 22 + height},
                      AxisSpec::ofValues(last ? label : "", errors, false), AxisSpec::ofValues("Share", shares));
    const double binWidth = panel.x(1) - panel.x(0);
    figure.description += fmt::format(" {}:", series.name);
    for (const auto& [value, count] : gathered(series)) {
      if (count == 0) {
        continue;
      }
      const double x = panel.x(value);
      const double share = static_cast<double>(count) / static_cast<double>(total);
      const double half = 0.4 * binWidth;
      figure.drawing.box("bar", {x - half, panel.y(share), x + half, panel.area().bottom}, seriesStyle(s).paint);
      const std::string text = numberText(static_cast<double>(count), 0);
      if (textWidth(text, Face::kSans, kTextSize) < binWidth) {
        figure.drawing.text("count", {x, panel.y(share) - 1}, text,
                            {.paint = kTextPaint, .across = Across::kMiddle, .down = Down::kBottom});
      }
      figure.description += fmt::format(" {} by {};", count, signedText(value));
    }
    top += 22 + height + 6;
  }
  figure.height = top - 4;
  return figure;
}

}  // namespace ocelli
