#include "analysis/plot/model_check_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/base/distributions.h"
#include "analysis/plot/chart_text.h"
#include "analysis/plot/panel.h"
#include "analysis/plot/swarm.h"

namespace ocelli {
namespace {

constexpr double kCheckHeight = 185;
constexpr double kCheckGap = 16;
constexpr size_t kBandPoints = 60;

struct Spread {
  double mean = 0;
  double deviation = 0;
};

Spread spreadOf(const std::vector<double>& values) {
  Spread spread;
  for (const double value : values) {
    spread.mean += value / static_cast<double>(values.size());
  }
  double sum = 0;
  for (const double value : values) {
    sum += (value - spread.mean) * (value - spread.mean);
  }
  spread.deviation = values.size() > 1 ? std::sqrt(sum / static_cast<double>(values.size() - 1)) : 0;
  return spread;
}

void drawPoints(Drawing& drawing, const std::vector<PlotPoint>& points, size_t all) {
  for (const PlotPoint& point : points) {
    drawing.marker("point",
                   {point, Marker::kCircle, kPointRadius, seriesStyle(1).paint.faded(pointOpacity(all)), std::nullopt});
  }
}

void drawResiduals(Drawing& drawing, const ModelCheckPlot& plot, const std::vector<double>& fitted,
                   const std::vector<double>& residuals, const PlotBox& box) {
  const Panel panel(drawing, box, AxisSpec::ofValues(plot.fittedLabel, AxisRange::of(fitted), false),
                    AxisSpec::ofValues(plot.residualLabel, AxisRange::of(residuals).with(0)));
  drawing.line("reference", panel.at(panel.xAxis().low(), 0), panel.at(panel.xAxis().high(), 0),
               {kReferencePaint, kLine, {3, 2}});
  std::vector<PlotPoint> points;
  for (const size_t i : drawnPoints(residuals, 2 * kMaxPoints)) {
    points.push_back(panel.at(fitted[i], residuals[i]));
  }
  drawPoints(drawing, points, residuals.size());
}

void drawQuantiles(Drawing& drawing, const std::string& label, std::vector<double> residuals, const Spread& spread,
                   const PlotBox& box) {
  std::sort(residuals.begin(), residuals.end());
  const size_t n = residuals.size();
  const auto expected = [&](double normal) { return spread.mean + spread.deviation * normal; };
  const NormalOrder first = normalOrder(0, n);
  AxisRange x = AxisRange::of({first.median, -first.median});
  AxisRange y = AxisRange::of(residuals).with(expected(first.lower)).with(expected(-first.lower));
  const Panel panel(drawing, box, AxisSpec::ofValues("Normal quantile", x, false),
                    AxisSpec::ofValues(fmt::format("{}, sorted", label), y));
  std::vector<PlotPoint> outline;
  std::vector<PlotPoint> lower;
  const size_t steps = std::min(n, kBandPoints);
  for (size_t i = 0; i < steps; ++i) {
    const NormalOrder order = normalOrder(steps > 1 ? i * (n - 1) / (steps - 1) : 0, n);
    outline.push_back(panel.at(order.median, expected(order.upper)));
    lower.push_back(panel.at(order.median, expected(order.lower)));
  }
  outline.insert(outline.end(), lower.rbegin(), lower.rend());
  drawing.path("band", {{outline}, true, kAxisPaint.faded(0.14), std::nullopt});
  drawing.line("reference", panel.at(panel.xAxis().low(), expected(panel.xAxis().low())),
               panel.at(panel.xAxis().high(), expected(panel.xAxis().high())), {kReferencePaint, kLine, {3, 2}});
  std::vector<PlotPoint> points;
  for (const size_t i : drawnPoints(residuals, kMaxPoints)) {
    points.push_back(panel.at(normalOrder(i, n).median, residuals[i]));
  }
  drawPoints(drawing, points, n);
}

}  // namespace

NormalOrder normalOrder(size_t k, size_t n) {
  const auto at = [&](double share) { return normalQuantile(orderStatisticQuantile(share, k, n)); };
  return {at(0.025), at(0.5), at(0.975)};
}

Figure modelCheckFigure(const ModelCheckPlot& plot) {
  std::vector<double> fitted;
  std::vector<double> residuals;
  for (size_t i = 0; i < std::min(plot.fitted.size(), plot.residuals.size()); ++i) {
    if (std::isfinite(plot.fitted[i]) && std::isfinite(plot.residuals[i])) {
      fitted.push_back(plot.fitted[i]);
      residuals.push_back(plot.residuals[i]);
    }
  }
  if (residuals.empty()) {
    return emptyFigure(plot.title, plot.widthMillimetres, "the model has no residuals");
  }
  const Spread spread = spreadOf(residuals);
  Figure figure{plot.title, "", plot.widthMillimetres * kPointsPerMillimetre, kCheckHeight, {}};
  const auto far = std::count_if(residuals.begin(), residuals.end(), [&](double residual) {
    return std::abs(residual - spread.mean) > 3 * spread.deviation;
  });
  figure.description = fmt::format(
      "Left: {} residuals against fitted values. Right: the sorted residuals against normal quantiles, with a line for "
      "a "
      "normal distribution and a band that holds each point in 95 % of samples. Standard deviation {}; {} lie more "
      "than "
      "three of these from their mean.",
      residuals.size(), shortNumberText(spread.deviation), far);
  if (residuals.size() > kMaxPoints) {
    figure.description += " Not all points are drawn: evenly by rank, with the least and the greatest.";
  }
  const double half = (figure.width - kCheckGap) / 2;
  drawResiduals(figure.drawing, plot, fitted, residuals, {0, 0, half, kCheckHeight});
  drawQuantiles(figure.drawing, plot.residualLabel, residuals, spread,
                {half + kCheckGap, 0, figure.width - 2, kCheckHeight});
  return figure;
}

Figure quantileFigure(const QuantilePlot& plot) {
  std::vector<QuantilePlot::Panel> panels;
  for (QuantilePlot::Panel panel : plot.panels) {
    std::erase_if(panel.values, [](double value) { return !std::isfinite(value); });
    if (panel.values.size() > 1) {
      panels.push_back(std::move(panel));
    }
  }
  if (panels.empty()) {
    return emptyFigure(plot.title, plot.widthMillimetres, "there are no values");
  }
  const auto rows = static_cast<double>((panels.size() + 1) / 2);
  Figure figure{plot.title,
                "Sorted values against normal quantiles, with a band that holds each point in 95 % of samples.",
                plot.widthMillimetres * kPointsPerMillimetre,
                rows * kCheckHeight + (rows - 1) * kCheckGap,
                {}};
  const double half = (figure.width - kCheckGap) / 2;
  for (size_t i = 0; i < panels.size(); ++i) {
    const Spread spread = spreadOf(panels[i].values);
    const double left = i % 2 == 0 ? 0 : half + kCheckGap;
    const double top = static_cast<double>(i / 2) * (kCheckHeight + kCheckGap);
    drawQuantiles(figure.drawing, panels[i].label, panels[i].values, spread,
                  {left, top, left + half - 2, top + kCheckHeight});
    figure.description += fmt::format(" {}: {} values, standard deviation {}.", panels[i].label,
                                      panels[i].values.size(), shortNumberText(spread.deviation));
  }
  return figure;
}

}  // namespace ocelli
