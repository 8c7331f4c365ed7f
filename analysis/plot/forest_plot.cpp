#include "analysis/plot/forest_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/plot/chart_text.h"

namespace ocelli {
namespace {

constexpr double kForestRowHeight = 15;
constexpr double kNumbersShare = 0.25;  // of the width
constexpr double kLabelShare = 0.33;
constexpr double kWidest = 4;  // times the median distance of ends from the reference, else an arrow
constexpr double kForestArrow = 3.5;

bool hasNumbers(const ForestPlot::Row& row, AxisScale scale) {
  return !row.heading && isDrawable(row.interval.value, scale);
}

double distance(double value, AxisScale scale) {
  return scale == AxisScale::kLog ? std::abs(std::log(value)) : std::abs(value);
}

/// As far as most intervals go.
AxisRange rangeOf(const ForestPlot& plot, AxisScale scale) {
  std::vector<double> distances;
  std::vector<double> all;
  for (const ForestPlot::Row& row : plot.rows) {
    if (hasNumbers(row, scale)) {
      for (const double value : {row.interval.value, row.interval.lower, row.interval.upper}) {
        if (isDrawable(value, scale)) {
          distances.push_back(distance(value, scale));
          all.push_back(value);
        }
      }
    }
  }
  std::sort(distances.begin(), distances.end());
  const double most = kWidest * distances[distances.size() / 2];
  // The reference has something on both sides of it.
  std::vector<double> shown = plot.ratio ? std::vector{0.95, 1.05} : std::vector{0.0, 0.05 * most, -0.05 * most};
  for (const double value : all) {
    if (distance(value, scale) <= most) {
      shown.push_back(value);
    }
  }
  if (plot.equivalence) {
    shown.insert(shown.end(), plot.equivalence->begin(), plot.equivalence->end());
  }
  return AxisRange::of(shown, scale);
}

/// "0.66 (0.58 to 0.75)": as many decimals in all rows, more where values are small.
std::string numbersText(const Interval& interval) {
  const auto text = [](double value) {
    const double size = std::abs(value);
    return numberText(value, size >= 100 ? 0 : size >= 9.95 ? 1 : size >= 0.095 || size == 0 ? 2 : 3);
  };
  if (!std::isfinite(interval.lower) || !std::isfinite(interval.upper)) {
    return text(interval.value);
  }
  return fmt::format("{} ({} to {})", text(interval.value), text(interval.lower), text(interval.upper));
}

void drawArrow(Drawing& drawing, PlotPoint tip, double direction, const Paint& paint) {
  drawing.path("arrow", {{{tip,
                           {tip.x - direction * kForestArrow, tip.y - kForestArrow * 0.7},
                           {tip.x - direction * kForestArrow, tip.y + kForestArrow * 0.7}}},
                         true,
                         paint,
                         std::nullopt});
}

void drawEstimate(Drawing& drawing, const Panel& panel, double y, const ForestPlot::Row& row, AxisScale scale) {
  const SeriesStyle style =
      row.main ? SeriesStyle{seriesStyle(1).paint, Marker::kDiamond, {}} : SeriesStyle{kTextPaint, Marker::kSquare, {}};
  // 0 and infinity, of a ratio, lie beyond every axis.
  const Interval& interval = row.interval;
  const double lower = std::isnan(interval.lower) ? interval.value : std::max(interval.lower, panel.xAxis().low());
  const double upper = std::isnan(interval.upper) ? interval.value : std::min(interval.upper, panel.xAxis().high());
  const bool valueShown = panel.xAxis().holds(interval.value);
  drawLevelInterval(drawing, panel, y, {valueShown ? interval.value : std::nan(""), lower, upper}, style);
  if (!std::isnan(interval.lower) && !panel.xAxis().holds(interval.lower) && isDrawable(upper, scale)) {
    drawArrow(drawing, {panel.area().left, y}, -1, style.paint);
  }
  if (!std::isnan(interval.upper) && !panel.xAxis().holds(interval.upper)) {
    drawArrow(drawing, {panel.area().right, y}, 1, style.paint);
  }
}

}  // namespace

Figure forestFigure(const ForestPlot& plot) {
  const AxisScale scale = plot.ratio ? AxisScale::kLog : AxisScale::kLinear;
  if (std::none_of(plot.rows.begin(), plot.rows.end(), [&](const auto& row) { return hasNumbers(row, scale); })) {
    return emptyFigure(plot.title, plot.widthMillimetres, "nothing could be estimated");
  }
  Figure figure{plot.title,
                fmt::format("{}, with intervals.", plot.valueLabel),
                plot.widthMillimetres * kPointsPerMillimetre,
                0,
                {}};
  const double labelsRight = kLabelShare * figure.width;
  const double numbersLeft = (1 - kNumbersShare) * figure.width;
  const bool sides = !plot.lowerSide.empty() || !plot.upperSide.empty();
  const double top = sides ? 14 : 2;
  const double rowsHeight = kForestRowHeight * static_cast<double>(plot.rows.size());
  figure.height = top + rowsHeight + 34;
  const PlotBox outer{labelsRight + 6, top, numbersLeft - 6, figure.height};
  Drawing& drawing = figure.drawing;
  // One category without a name: rows are placed here, beside their text.
  const Panel panel(drawing, outer, AxisSpec::ofValues(plot.valueLabel, rangeOf(plot, scale), false),
                    AxisSpec::ofCategories("", {""}));
  const PlotBox& area = panel.area();
  if (plot.equivalence) {
    drawing.box("equivalence",
                {panel.x((*plot.equivalence)[0]), area.top, panel.x((*plot.equivalence)[1]), area.bottom},
                seriesStyle(2).paint.faded(0.12));
  }
  const double reference = panel.x(plot.ratio ? 1 : 0);
  drawing.line("reference", {reference, area.top}, {reference, area.bottom}, {kReferencePaint, kThinLine, {2, 2}});
  if (sides) {
    drawing.text("side", {reference - 6, 1}, plot.lowerSide.empty() ? "" : fmt::format("\u2190 {}", plot.lowerSide),
                 {.paint = kSoftTextPaint, .across = Across::kRight, .down = Down::kTop});
    drawing.text("side", {reference + 6, 1}, plot.upperSide.empty() ? "" : fmt::format("{} \u2192", plot.upperSide),
                 {.paint = kSoftTextPaint, .down = Down::kTop});
  }
  const double rowHeight = area.height() / static_cast<double>(plot.rows.size());
  for (size_t i = 0; i < plot.rows.size(); ++i) {
    const ForestPlot::Row& row = plot.rows[i];
    const double y = area.top + rowHeight * (static_cast<double>(i) + 0.5);
    const Face face = row.heading || row.main ? Face::kSansBold : Face::kSans;
    const double indent = row.heading ? 0 : 8;
    drawing.text("label", {indent, y},
                 shortened(row.label, face, kTextSize, (row.heading ? figure.width : labelsRight) - indent),
                 {.face = face, .paint = kTextPaint, .down = Down::kMiddle});
    if (row.heading) {
      continue;
    }
    const bool numbers = hasNumbers(row, scale);
    const std::string text = numbers ? numbersText(row.interval) : row.reason.empty() ? "not estimable" : row.reason;
    drawing.text("numbers", {figure.width, y}, shortened(text, face, kTextSize, figure.width - numbersLeft),
                 {.face = face,
                  .paint = numbers ? kTextPaint : kSoftTextPaint,
                  .across = Across::kRight,
                  .down = Down::kMiddle});
    figure.description += fmt::format(" {}: {}.", row.label, text);
    if (numbers) {
      drawEstimate(drawing, panel, y, row, scale);
    }
  }
  return figure;
}

}  // namespace ocelli
