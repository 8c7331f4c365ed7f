#include "analysis/plot/survival_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/plot/chart_text.h"

namespace ocelli {
namespace {

constexpr double kSurvivalHeight = 170;
constexpr double kRiskRow = 11;
constexpr double kBandOpacity = 0.16;
constexpr double kMinStep = 0.12;  // points: less is not seen
constexpr double kCensorRadius = 2.8;

/// Corners of the steps of what `value` takes from each, from 1 at time 0 to the limit. Steps without a value are left
/// out: what was before goes on. Steps that follow at once are drawn as one.
template <class Value>
std::vector<PlotPoint> stepCorners(const SurvivalPlot& plot, const SurvivalPlot::Curve& curve, const Panel& panel,
                                   Value value) {
  std::vector<PlotPoint> corners{panel.at(0, 1)};
  double last = 1;
  for (const SurvivalPlot::Step& step : curve.steps) {
    if (!std::isfinite(value(step)) || !(step.time <= plot.limit)) {
      continue;
    }
    const PlotPoint before = panel.at(step.time, last);
    last = value(step);
    if (corners.size() > 1 && before.x - corners.back().x < kMinStep) {
      corners.back().y = panel.y(last);
    } else {
      corners.push_back(before);
      corners.push_back(panel.at(step.time, last));
    }
  }
  corners.push_back(panel.at(plot.limit, last));
  return corners;
}

double survivalAt(const SurvivalPlot::Curve& curve, double time) {
  double survival = 1;
  for (const SurvivalPlot::Step& step : curve.steps) {
    if (step.time <= time) {
      survival = step.survival;
    }
  }
  return survival;
}

std::string medianText(const SurvivalPlot::Curve& curve) {
  for (const SurvivalPlot::Step& step : curve.steps) {
    if (step.survival <= 0.5) {
      return fmt::format("half by {}", shortNumberText(step.time));
    }
  }
  return "fewer than half until the end";
}

void drawCurve(Drawing& drawing, const SurvivalPlot& plot, const Panel& panel, size_t index) {
  const SurvivalPlot::Curve& curve = plot.curves[index];
  const SeriesStyle style = seriesStyle(index);
  drawing.polyline("curve",
                   stepCorners(plot, curve, panel, [](const SurvivalPlot::Step& step) { return step.survival; }),
                   {style.paint, kThickLine, style.dash});
  // Many are censored at the same time: one mark.
  std::vector<double> times = curve.censoredTimes;
  std::sort(times.begin(), times.end());
  double lastX = -1;
  for (const double time : times) {
    if (panel.xAxis().holds(time) && panel.x(time) > lastX + kMinStep) {
      lastX = panel.x(time);
      drawing.marker("censored", {panel.at(time, survivalAt(curve, time)), Marker::kPlus, kCensorRadius, std::nullopt,
                                  Pen{style.paint, kLine}});
    }
  }
}

void drawBand(Drawing& drawing, const SurvivalPlot& plot, const Panel& panel, size_t index) {
  const SurvivalPlot::Curve& curve = plot.curves[index];
  if (std::none_of(curve.steps.begin(), curve.steps.end(),
                   [](const auto& step) { return std::isfinite(step.lower) && std::isfinite(step.upper); })) {
    return;
  }
  std::vector<PlotPoint> outline =
      stepCorners(plot, curve, panel, [](const SurvivalPlot::Step& step) { return step.upper; });
  const std::vector<PlotPoint> lower =
      stepCorners(plot, curve, panel, [](const SurvivalPlot::Step& step) { return step.lower; });
  outline.insert(outline.end(), lower.rbegin(), lower.rend());
  drawing.path("band", {{outline}, true, seriesStyle(index).paint.faded(kBandOpacity), std::nullopt});
}

/// Under the axis, each number below its time, as far as they have room.
void drawRisk(Drawing& drawing, const SurvivalPlot& plot, const Panel& panel, double top) {
  drawing.text("risk title", {0, top}, "Number at risk", {.paint = kSoftTextPaint, .down = Down::kTop});
  for (size_t i = 0; i < plot.curves.size(); ++i) {
    const double middle = top + kLineHeight + 2 + kRiskRow * (static_cast<double>(i) + 0.5);
    double end = panel.area().left - 12;
    drawing.text("risk name", {0, middle}, shortened(plot.curves[i].name, Face::kSansBold, kTextSize, end - 2),
                 {.face = Face::kSansBold, .paint = seriesStyle(i).paint, .down = Down::kMiddle});
    for (size_t k = 0; k < plot.riskTimes.size() && k < plot.curves[i].atRisk.size(); ++k) {
      const std::string text = numberText(static_cast<double>(plot.curves[i].atRisk[k]), 0);
      const double x = panel.x(plot.riskTimes[k]);
      const double half = textWidth(text, Face::kSans, kTextSize) / 2;
      if (panel.xAxis().holds(plot.riskTimes[k]) && x - half > end + 2) {
        drawing.text("at risk", {x, middle}, text,
                     {.paint = kTextPaint, .across = Across::kMiddle, .down = Down::kMiddle});
        end = x + half;
      }
    }
  }
}

}  // namespace

Figure survivalFigure(const SurvivalPlot& plot) {
  const bool any = std::any_of(plot.curves.begin(), plot.curves.end(), [](const SurvivalPlot::Curve& curve) {
    return !curve.steps.empty() || !curve.censoredTimes.empty();
  });
  if (!any || !(plot.limit > 0) || !std::isfinite(plot.limit)) {
    return emptyFigure(plot.title, plot.widthMillimetres, "no trial has a time");
  }
  Figure figure{plot.title,
                fmt::format("{} by {}, 0 to {}.", plot.survivalLabel, plot.timeLabel, shortNumberText(plot.limit)),
                plot.widthMillimetres * kPointsPerMillimetre,
                0,
                {}};
  std::vector<LegendEntry> entries;
  for (size_t i = 0; i < plot.curves.size(); ++i) {
    const SurvivalPlot::Curve& curve = plot.curves[i];
    entries.push_back({curve.name, seriesStyle(i), false, true});
    figure.description += fmt::format(" {}: {}, {} left at the end, {} censored.", curve.name, medianText(curve),
                                      percentText(survivalAt(curve, plot.limit), 1), curve.censoredTimes.size());
  }
  entries.push_back({"censored", {kSoftTextPaint, Marker::kPlus, {}}, true, false, true, kCensorRadius});
  const double legend = drawLegend(figure.drawing, {0, 0, figure.width, 0}, entries);
  const bool table = !plot.riskTimes.empty();
  const double bottom = legend + kSurvivalHeight;
  figure.height = bottom + (table ? 6 + kLineHeight + 2 + kRiskRow * static_cast<double>(plot.curves.size()) + 2 : 0);
  AxisRange time;
  time.high = plot.limit;
  time.roundHigh = false;
  AxisRange survival;
  survival.percent = true;
  // The first number at risk stands half left of the area.
  const Panel panel(figure.drawing, {0, legend, figure.width - 4, bottom},
                    AxisSpec::ofValues(plot.timeLabel, time, false), AxisSpec::ofValues(plot.survivalLabel, survival));
  for (size_t i = 0; i < plot.curves.size(); ++i) {
    drawBand(figure.drawing, plot, panel, i);
  }
  for (size_t i = 0; i < plot.curves.size(); ++i) {
    drawCurve(figure.drawing, plot, panel, i);
  }
  if (table) {
    drawRisk(figure.drawing, plot, panel, bottom + 6);
  }
  return figure;
}

}  // namespace ocelli
