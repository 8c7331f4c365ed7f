#include "oc_core/remote_measure/remote_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "oc_core/drawing/series_style.h"
#include "oc_core/page/html.h"

namespace ocelli {
namespace {

constexpr double kWidth = 640;
constexpr double kLeft = 70;
constexpr double kRight = 620;
constexpr double kPlotHeight = 300;
constexpr double kBelow = 50;
constexpr double kTitleLine = 26;
constexpr double kLegendLine = 18;
constexpr double kLetter = 7.2;
constexpr double kMarkerSize = 4.5;
constexpr double kDashScale = 1.8;
constexpr int kTicks = 5;

/// The least of 1, 2 and 5 times a power of ten that is no less.
double roundStep(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)));
  for (const double mantissa : {1.0, 2.0, 5.0}) {
    if (mantissa * unit >= value * (1 - 1e-9)) {
      return mantissa * unit;
    }
  }
  return 10 * unit;
}

/// From values to a place along one side of the chart.
class Scale {
 public:
  Scale(const std::vector<double>& values, bool isLogarithmic, double from, double to)
      : isLogarithmic_(isLogarithmic), from_(from), to_(to) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const double value : values) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
    if (isLogarithmic) {
      low_ = std::pow(10, std::floor(std::log10(least) + 1e-9));
      high_ = std::pow(10, std::ceil(std::log10(most) - 1e-9));
      high_ = high_ > low_ ? high_ : 10 * low_;
      for (double tick = low_; tick <= high_ * 1.001; tick *= 10) {
        ticks_.push_back(tick);
      }
      return;
    }
    low_ = std::min(0.0, least);
    const double step = roundStep(std::max(most - low_, 1e-9) / kTicks);
    low_ = std::floor(low_ / step) * step;
    high_ = std::max(std::ceil(most / step - 1e-9) * step, low_ + step);
    for (int i = 0; low_ + i * step <= high_ + step / 2; ++i) {
      ticks_.push_back(low_ + i * step);
    }
  }

  double at(double value) const {
    const auto linear = [this](double v) { return isLogarithmic_ ? std::log10(v) : v; };
    return from_ + (to_ - from_) * (linear(value) - linear(low_)) / (linear(high_) - linear(low_));
  }
  const std::vector<double>& ticks() const { return ticks_; }

 private:
  bool isLogarithmic_;
  double from_, to_;
  double low_ = 0;
  double high_ = 1;
  std::vector<double> ticks_;
};

std::string markerOf(double x, double y, const SeriesStyle& style) {
  const std::string paint = fmt::format("var(--{})", style.colorName);
  const std::vector<PlotPoint> corners = markerCorners(style.marker);
  if (corners.empty()) {
    return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" style="fill: {}"/>)", x, y, kMarkerSize, paint);
  }
  const bool strokes = style.marker == Marker::kPlus || style.marker == Marker::kCross;
  std::string path;
  for (size_t i = 0; i < corners.size(); ++i) {
    path += fmt::format("{}{:.1f} {:.1f}", (strokes ? i % 2 == 0 : i == 0) ? "M" : "L", x + corners[i].x * kMarkerSize,
                        y + corners[i].y * kMarkerSize);
  }
  return strokes ? fmt::format(R"(<path d="{}" style="stroke: {}; stroke-width: 2.5"/>)", path, paint)
                 : fmt::format(R"(<path d="{}Z" style="fill: {}"/>)", path, paint);
}

std::string strokeOf(const SeriesStyle& style) {
  std::string dash;
  for (const double length : style.dash) {
    dash += fmt::format("{}{:g}", dash.empty() ? "" : " ", kDashScale * length);
  }
  return fmt::format("fill: none; stroke: var(--{}); stroke-width: 2; stroke-dasharray: {}", style.colorName,
                     dash.empty() ? "none" : dash);
}

struct LegendPlace {
  double x;
  double y;
};

/// Names side by side, as many to a line as fit.
std::vector<LegendPlace> legendPlaces(const std::vector<ChartSeries>& series) {
  std::vector<LegendPlace> places;
  double x = kLeft;
  double y = kTitleLine + kLegendLine;
  for (const ChartSeries& each : series) {
    const double width = 34 + kLetter * static_cast<double>(each.name.size()) + 14;
    if (x > kLeft && x + width > kRight) {
      x = kLeft;
      y += kLegendLine;
    }
    places.push_back({x, y});
    x += width;
  }
  return places;
}

}  // namespace

std::string remoteChart(const std::string& title, const ChartAxis& x, const ChartAxis& y,
                        const std::vector<ChartSeries>& series) {
  const auto isDrawn = [&](const std::pair<double, double>& point) {
    return (!x.isLogarithmic || point.first > 0) && (!y.isLogarithmic || point.second > 0) &&
           std::isfinite(point.first) && std::isfinite(point.second);
  };
  std::vector<double> xs;
  std::vector<double> ys;
  for (const ChartSeries& each : series) {
    for (const auto& point : each.points) {
      if (isDrawn(point)) {
        xs.push_back(point.first);
        ys.push_back(point.second);
      }
    }
  }
  if (xs.empty()) {
    return fmt::format("<p>{}: nothing to draw.</p>\n", htmlFromText(title));
  }
  const std::vector<LegendPlace> legend = legendPlaces(series);
  const double top = legend.back().y + 34;
  const double bottom = top + kPlotHeight;
  const Scale across(xs, x.isLogarithmic, kLeft, kRight);
  const Scale up(ys, y.isLogarithmic, bottom, top);
  std::string svg = fmt::format(
      "<svg viewBox=\"0 0 {} {:.0f}\" role=\"img\" aria-label=\"{}\">\n<text x=\"14\" y=\"22\" style=\"font-weight: "
      "600\">{}</text>\n",
      kWidth, bottom + kBelow, htmlFromText(title), htmlFromText(title));
  for (const double tick : up.ticks()) {
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{} {:.1f}H{}\"/><text class=\"tick\" text-anchor=\"end\" x=\"{}\" "
        "y=\"{:.1f}\">{:g}</text>\n",
        kLeft, up.at(tick), kRight, kLeft - 6, up.at(tick) + 4, tick);
  }
  for (const double tick : across.ticks()) {
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{:.1f} {}V{}\"/><text class=\"tick\" text-anchor=\"middle\" x=\"{:.1f}\" "
        "y=\"{}\">{:g}</text>\n",
        across.at(tick), top, bottom, across.at(tick), bottom + 18, tick);
  }
  svg += fmt::format("<path class=\"axis\" d=\"M{} {}V{}H{}\"/>\n", kLeft, top, bottom, kRight);
  svg += fmt::format("<text class=\"tick\" x=\"14\" y=\"{}\">{}</text>", top - 12, htmlFromText(y.title));
  svg += fmt::format("<text class=\"tick\" text-anchor=\"end\" x=\"{}\" y=\"{}\">{}</text>\n", kRight, bottom + 38,
                     htmlFromText(x.title));
  for (size_t i = 0; i < series.size(); ++i) {
    const ChartSeries& each = series[i];
    const SeriesStyle style = seriesStyle(each.style);
    std::string path;
    std::string markers;
    for (const auto& point : each.points) {
      if (isDrawn(point)) {
        const double px = across.at(point.first);
        const double py = up.at(point.second);
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", px, py);
        markers += each.hasMarkers ? markerOf(px, py, style) : "";
      }
    }
    const std::string stroke = strokeOf(style);
    svg += fmt::format("<g><title>{}</title>", htmlFromText(each.name));
    if (each.isLine) {
      svg += fmt::format("<path d=\"{}\" style=\"{}\"/>", path, stroke);
      svg += fmt::format("<path d=\"M{:.1f} {:.1f}h26\" style=\"{}\"/>", legend[i].x, legend[i].y - 4, stroke);
    }
    if (each.hasMarkers) {
      svg += markers + markerOf(legend[i].x + 13, legend[i].y - 4, style);
    }
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text></g>\n", legend[i].x + 34, legend[i].y,
                       htmlFromText(each.name));
  }
  return svg + "</svg>\n";
}

}  // namespace ocelli
