#include "analysis/plot/trade_off_plot.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/plot/chart_text.h"

namespace ocelli {
namespace {

constexpr double kTradeOffHeight = 190;

bool canDraw(const TradeOffPlot::Point& point) {
  return isDrawable(point.seconds, AxisScale::kLog) && isDrawable(point.share, AxisScale::kLinear);
}

std::string textOf(const TradeOffPlot::Point& point) {
  return canDraw(point) ? fmt::format("{:.3g} s, {:.0f} %", point.seconds, 100 * point.share) : "not known";
}

}  // namespace

Figure tradeOffFigure(const TradeOffPlot& plot) {
  std::vector<double> times;
  size_t points = 0;
  size_t subjects = 0;
  for (const TradeOffPlot::Condition& condition : plot.conditions) {
    subjects = std::max(subjects, condition.subjects.size());
    for (const TradeOffPlot::Point& point : condition.subjects) {
      if (canDraw(point)) {
        times.push_back(point.seconds);
        ++points;
      }
    }
  }
  if (points == 0) {
    return emptyFigure(plot.title, plot.widthMillimetres, "no subject has both a time and a right or wrong answer");
  }
  AxisRange shares = AxisRange::of({0, 1}, AxisScale::kLinear);
  shares.percent = true;

  Figure figure{plot.title, "", plot.widthMillimetres * kPointsPerMillimetre, kTradeOffHeight, {}};
  figure.description = fmt::format("{} against {} of {} subjects. Means:", plot.shareLabel, plot.timeLabel, subjects);
  std::vector<LegendEntry> legend;
  for (size_t i = 0; i < plot.conditions.size(); ++i) {
    const TradeOffPlot::Condition& condition = plot.conditions[i];
    figure.description += fmt::format("{} {} {}", i == 0 ? "" : ";", condition.name, textOf(condition.mean));
    legend.push_back({condition.name + ", mean", seriesStyle(i)});
  }
  figure.description += '.';
  legend.push_back({"one subject", {kSoftTextPaint.faded(0.5), Marker::kCircle, {}}, true, true, true, kPointRadius});
  const double top = drawLegend(figure.drawing, {0, 0, figure.width, 0}, legend);
  const Panel panel(figure.drawing, {0, top, figure.width, kTradeOffHeight},
                    AxisSpec::ofValues(plot.timeLabel, AxisRange::of(times, AxisScale::kLog)),
                    AxisSpec::ofValues(plot.shareLabel, shares));
  const double opacity = pointOpacity(points);
  for (size_t subject = 0; subject < subjects; ++subject) {
    const TradeOffPlot::Point* before = nullptr;
    for (const TradeOffPlot::Condition& condition : plot.conditions) {
      const TradeOffPlot::Point* point = subject < condition.subjects.size() ? &condition.subjects[subject] : nullptr;
      if (point == nullptr || !canDraw(*point)) {
        continue;
      }
      if (before != nullptr) {
        figure.drawing.line("link", panel.at(before->seconds, before->share), panel.at(point->seconds, point->share),
                            {kSoftTextPaint.faded(0.8 * opacity), kThinLine});
      }
      before = point;
    }
  }
  for (size_t i = 0; i < plot.conditions.size(); ++i) {
    const SeriesStyle style = seriesStyle(i);
    for (const TradeOffPlot::Point& point : plot.conditions[i].subjects) {
      if (canDraw(point)) {
        figure.drawing.marker("point", {panel.at(point.seconds, point.share), style.marker, kPointRadius,
                                        style.paint.faded(std::min(2 * opacity, 0.8)), std::nullopt});
      }
    }
  }
  for (size_t i = 0; i < plot.conditions.size(); ++i) {
    const TradeOffPlot::Point& mean = plot.conditions[i].mean;
    if (canDraw(mean)) {
      const SeriesStyle style = seriesStyle(i);
      // On white, so that it stands out from the subjects.
      figure.drawing.marker(
          "summary", {panel.at(mean.seconds, mean.share), style.marker, kSummaryRadius + 1, kWhite, std::nullopt});
      figure.drawing.marker(
          "summary", {panel.at(mean.seconds, mean.share), style.marker, kSummaryRadius, style.paint, std::nullopt});
    }
  }
  return figure;
}

}  // namespace ocelli
