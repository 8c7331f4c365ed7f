#include "oc_core/evaluation/evaluation_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "oc_core/drawing/series_style.h"
#include "oc_core/page/html.h"

namespace ocelli {
namespace {

constexpr double kWidth = 640;
constexpr double kHeight = 430;
constexpr double kLeft = 72;
constexpr double kTop = 64;
constexpr double kBottom = 56;
constexpr double kZeroRow = 34;       // height of the row for zeros, below the axis
constexpr double kLetterWidth = 7.4;  // of the labels, on average
constexpr double kLineHeight = 15;
constexpr double kMarker = 5.5;     // half size
constexpr double kDashScale = 1.8;  // lines are thicker than those of printed figures

std::string colorOf(const SeriesStyle& style) {
  return fmt::format("var(--{})", style.colorName);
}

std::string markerSvg(double x, double y, const SeriesStyle& style) {
  const std::string paint = colorOf(style);
  const std::vector<PlotPoint> corners = markerCorners(style.marker);
  if (corners.empty()) {
    return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" style="fill: {}"/>)", x, y, kMarker, paint);
  }
  const bool strokes = style.marker == Marker::kPlus || style.marker == Marker::kCross;
  std::string path;
  for (size_t i = 0; i < corners.size(); ++i) {
    const bool starts = strokes ? i % 2 == 0 : i == 0;
    path += fmt::format("{}{:.1f} {:.1f}", starts ? "M" : "L", x + corners[i].x * kMarker, y + corners[i].y * kMarker);
  }
  return strokes ? fmt::format(R"(<path d="{}" style="stroke: {}; stroke-width: 2.5"/>)", path, paint)
                 : fmt::format(R"(<path d="{}Z" style="fill: {}"/>)", path, paint);
}

std::string dashOf(const SeriesStyle& style) {
  std::string dash;
  for (const double length : style.dash) {
    dash += fmt::format("{}{:g}", dash.empty() ? "" : " ", kDashScale * length);
  }
  return dash.empty() ? "none" : dash;
}

std::string percentTick(double ratio) {
  return fmt::format("{:g} %", 100 * ratio);
}

std::string countTick(double count) {
  if (count >= 1e6) {
    return fmt::format("{:g} M", count / 1e6);
  }
  return count >= 1e3 ? fmt::format("{:g} K", count / 1e3) : fmt::format("{:g}", count);
}

/// Maps [low, high], whole parts of a decade, to [from, to].
class LogAxis {
 public:
  /// `steps` are the parts of a decade where the axis may end. Values that are not positive do not count.
  LogAxis(const std::vector<double>& values, double from, double to) : from_(from), to_(to) {
    double least = 1e300;
    double most = 0;
    for (const double value : values) {
      if (value > 0) {
        least = std::min(least, value);
        most = std::max(most, value);
      }
    }
    if (most == 0) {
      least = 1e-4;
      most = 1e-2;
    }
    low_ = roundedDown(least);
    high_ = roundedDown(most);
    while (high_ < most * 1.0001) {
      high_ = next(high_);
    }
  }

  double at(double value) const {
    return from_ + (to_ - from_) * (std::log10(value) - std::log10(low_)) / (std::log10(high_) - std::log10(low_));
  }
  /// 1, 2 and 5 of every decade on the axis; whether it gets a label.
  std::vector<std::pair<double, bool>> ticks() const {
    std::vector<std::pair<double, bool>> ticks;
    const bool few = std::log10(high_ / low_) < 2.1;
    double value = low_;
    while (value <= high_ * 1.0001) {
      const double mantissa = value / std::pow(10, std::floor(std::log10(value) + 1e-9));
      ticks.emplace_back(value, few || mantissa < 1.5);
      value = next(value);
    }
    return ticks;
  }

 private:
  static double decade(double value) { return std::pow(10, std::floor(std::log10(value) + 1e-9)); }
  static double roundedDown(double value) {
    const double unit = decade(value);
    return value >= 5 * unit ? 5 * unit : value >= 2 * unit ? 2 * unit : unit;
  }
  static double next(double value) {
    const double unit = decade(value);
    const double mantissa = value / unit;
    return mantissa < 1.5 ? 2 * unit : mantissa < 3 ? 5 * unit : 10 * unit;
  }

  double low_ = 1;
  double high_ = 1;
  double from_;
  double to_;
};

double labelWidth(const std::string& text) {
  return kLetterWidth * static_cast<double>(text.size());
}

std::string opening(const std::string& title) {
  return fmt::format(
      "<svg viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"{2}\">\n<text x=\"{3}\" y=\"24\" "
      "style=\"font-weight: 600\">{2}</text>\n",
      kWidth, kHeight, htmlFromText(title), kLeft - 56);
}

std::string line(const char* kind, double x0, double y0, double x1, double y1) {
  return fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", kind, x0, y0, x1, y1);
}

/// The frame with the error axis on its left. Between `floor` and the bottom lies the row for zeros.
struct ErrorAxis {
  LogAxis axis;
  double right;
  bool zeros;

  ErrorAxis(const std::vector<double>& errors, double rightEdge)
      : axis(errors, kHeight - kBottom - (hasZero(errors) ? kZeroRow : 0), kTop),
        right(rightEdge),
        zeros(hasZero(errors)) {}

  static bool hasZero(const std::vector<double>& errors) {
    return std::any_of(errors.begin(), errors.end(), [](double error) { return !(error > 0); });
  }
  static double bottom() { return kHeight - kBottom; }
  double at(double error) const { return error > 0 ? axis.at(error) : bottom() - kZeroRow / 2; }

  std::string svg(const std::string& yTitle) const {
    std::string svg;
    for (const auto& [value, labelled] : axis.ticks()) {
      svg += line("grid", kLeft, axis.at(value), right, axis.at(value));
      if (labelled) {
        svg += fmt::format(R"(<text class="tick" text-anchor="end" x="{}" y="{:.1f}">{}</text>)", kLeft - 6,
                           axis.at(value) + 4, percentTick(value));
      }
    }
    if (zeros) {
      svg += fmt::format(R"(<text class="tick" text-anchor="end" x="{}" y="{:.1f}">0</text>)", kLeft - 6, at(0) + 4);
      svg += line("axis", kLeft, bottom() - kZeroRow, right, bottom() - kZeroRow);
    }
    svg += fmt::format("<path class=\"axis\" d=\"M{} {}V{:.1f}H{:.1f}\"/>\n", kLeft, kTop, bottom(), right);
    svg += fmt::format(R"(<text class="tick" x="{}" y="{}">{}</text>)", kLeft - 56, kTop - 22, htmlFromText(yTitle));
    return svg;
  }
};

std::string xLabel(double x, double bottom, const std::string& text) {
  return fmt::format(R"(<text class="tick" text-anchor="middle" x="{:.1f}" y="{:.1f}">{}</text>)", x, bottom + 18,
                     text);
}

std::string xTitleText(double right, const std::string& title) {
  return fmt::format("<text class=\"tick\" text-anchor=\"end\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", right,
                     kHeight - 14, htmlFromText(title));
}

/// A place beside the marker where the label covers nothing.
std::optional<PlotBox> freePlace(double x, double y, const std::string& text, const std::vector<PlotBox>& taken,
                                 double right) {
  const double width = labelWidth(text);
  const double gap = kMarker + 4;
  const std::array<PlotPoint, 4> corners{{{x + gap, y - kLineHeight / 2},
                                          {x - gap - width, y - kLineHeight / 2},
                                          {x - width / 2, y - gap - kLineHeight},
                                          {x - width / 2, y + gap}}};
  for (const PlotPoint& corner : corners) {
    const PlotBox place{corner.x, corner.y, corner.x + width, corner.y + kLineHeight};
    const bool inside = place.left >= kLeft && place.right <= right && place.top >= kTop - kLineHeight / 2;
    if (inside && std::none_of(taken.begin(), taken.end(), [&](const PlotBox& o) { return place.overlaps(o); })) {
      return place;
    }
  }
  return std::nullopt;
}

/// A label in the right margin, with a line to what it names.
struct MarginLabel {
  const PlotSeries* series;
  double x;  ///< of what it names
  double y;
};

/// From the highest down; they push each other apart.
std::string marginLabels(std::vector<MarginLabel> labels, double right, double bottom) {
  std::stable_sort(labels.begin(), labels.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  std::vector<double> at(labels.size());
  double above = kTop - kLineHeight;
  for (size_t i = 0; i < labels.size(); ++i) {
    above = std::max(labels[i].y, above + kLineHeight);
    at[i] = above;
  }
  double below = bottom + kLineHeight;
  for (size_t i = labels.size(); i-- > 0;) {
    below = std::min(at[i], below - kLineHeight);
    at[i] = below;
  }
  std::string svg;
  for (size_t i = 0; i < labels.size(); ++i) {
    svg += line("leader", labels[i].x, labels[i].y, right + 18, at[i]) +
           markerSvg(right + 24, at[i], seriesStyle(labels[i].series->style)) +
           fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", right + 34, at[i] + 4,
                       htmlFromText(labels[i].series->name));
  }
  return svg;
}

/// The right edge of a plot that leaves room for labels in the margin.
double rightEdge(const std::vector<PlotSeries>& series) {
  double widest = 0;
  for (const PlotSeries& each : series) {
    widest = std::max(widest, labelWidth(each.name));
  }
  return kWidth - std::min(widest, kWidth / 3) - 50;
}

struct FrontierDrawing {
  std::string svg;
  bool usesMargin = false;  ///< whether labels stand right of `right`
};

FrontierDrawing drawFrontier(const std::string& title, const std::string& xTitle, const std::string& yTitle,
                             const std::vector<PlotSeries>& series, double right) {
  std::vector<double> counts;
  std::vector<double> errors;
  for (const PlotSeries& each : series) {
    counts.push_back(each.points.front().first);
    errors.push_back(each.points.front().second);
  }
  const ErrorAxis vertical(errors, right);
  const LogAxis horizontal(counts, kLeft + 20, right - 20);
  std::string svg = opening(title) + vertical.svg(yTitle);
  for (const auto& [value, labelled] : horizontal.ticks()) {
    svg += line("grid", horizontal.at(value), kTop, horizontal.at(value), vertical.bottom());
    if (labelled) {
      svg += xLabel(horizontal.at(value), vertical.bottom(), countTick(value));
    }
  }
  svg += xTitleText(right, xTitle);

  // From few samples to many: those with less error than all before them.
  std::vector<std::pair<double, double>> sorted;
  for (size_t i = 0; i < series.size(); ++i) {
    sorted.emplace_back(counts[i], errors[i]);
  }
  std::sort(sorted.begin(), sorted.end());
  std::string front;
  double least = 1e300;
  for (const auto& [count, error] : sorted) {
    if (error < least && count > 0) {
      front += front.empty() ? fmt::format("M{:.1f} {:.1f}", horizontal.at(count), vertical.at(error))
                             : fmt::format("H{:.1f}V{:.1f}", horizontal.at(count), vertical.at(error));
      least = error;
    }
  }
  svg += fmt::format("<path class=\"front\" d=\"{}\"/>\n", front);

  std::vector<PlotBox> taken;
  const auto xOf = [&](size_t i) { return horizontal.at(std::max(counts[i], 1.0)); };
  for (size_t i = 0; i < series.size(); ++i) {
    const double y = vertical.at(errors[i]);
    taken.push_back({xOf(i) - kMarker, y - kMarker, xOf(i) + kMarker, y + kMarker});
  }
  std::string labels;
  std::string markers;
  std::vector<MarginLabel> inMargin;
  for (size_t i = 0; i < series.size(); ++i) {
    const double x = xOf(i);
    const double y = vertical.at(errors[i]);
    markers += fmt::format("<g><title>{}: {:.0f}, {:.4g} %</title>{}</g>\n", htmlFromText(series[i].name), counts[i],
                           100 * errors[i], markerSvg(x, y, seriesStyle(series[i].style)));
    if (const auto label = freePlace(x, y, series[i].name, taken, right)) {
      taken.push_back(*label);
      labels += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", label->left, label->top + 11,
                            htmlFromText(series[i].name));
    } else {
      inMargin.push_back({&series[i], x, y});
    }
  }
  return {svg + marginLabels(inMargin, right, vertical.bottom()) + labels + markers + "</svg>\n", !inMargin.empty()};
}

}  // namespace

std::string frontierPlot(const std::string& title, const std::string& xTitle, const std::string& yTitle,
                         const std::vector<PlotSeries>& series) {
  // Labels beside their markers need no margin.
  const FrontierDrawing wide = drawFrontier(title, xTitle, yTitle, series, kWidth - 24);
  return wide.usesMargin ? drawFrontier(title, xTitle, yTitle, series, rightEdge(series)).svg : wide.svg;
}

std::string curvePlot(const std::string& title, const std::string& xTitle, const std::string& yTitle,
                      const std::vector<PlotSeries>& series) {
  std::vector<double> errors;
  for (const PlotSeries& each : series) {
    for (const auto& [x, error] : each.points) {
      errors.push_back(error);
    }
  }
  const double right = rightEdge(series);
  const ErrorAxis vertical(errors, right);
  const auto xAt = [&](double offset) { return kLeft + (right - kLeft) * offset; };
  std::string svg = opening(title) + vertical.svg(yTitle);
  for (int i = 0; i <= 5; ++i) {
    const double offset = i / 5.0;
    svg += line("grid", xAt(offset), kTop, xAt(offset), vertical.bottom());
    svg += xLabel(xAt(offset), vertical.bottom(), fmt::format("{:g}", offset));
  }
  svg += xTitleText(right, xTitle);

  std::vector<MarginLabel> labels;
  for (const PlotSeries& each : series) {
    if (each.points.empty()) {
      continue;
    }
    std::string path;
    for (const auto& [x, error] : each.points) {
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", xAt(x), vertical.at(error));
    }
    const double end = vertical.at(each.points.back().second);
    svg += fmt::format(
        "<g><title>{}</title><path d=\"{}\" style=\"fill: none; stroke: {}; stroke-width: 2; stroke-dasharray: "
        "{}\"/></g>\n",
        htmlFromText(each.name), path, colorOf(seriesStyle(each.style)), dashOf(seriesStyle(each.style)));
    labels.push_back({&each, right, end});
  }
  return svg + marginLabels(labels, right, vertical.bottom()) + "</svg>\n";
}

}  // namespace ocelli
