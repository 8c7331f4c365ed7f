#include "cli/evaluate_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/demo_page.h"

namespace ocelli {
namespace {

constexpr double kWidth = 640;
constexpr double kHeight = 430;
constexpr double kLeft = 72;
constexpr double kTop = 64;
constexpr double kBottom = 56;
constexpr double kZeroRow = 34;     // height of the row for zeros, below the axis
constexpr double kLetterWidth = 7;  // of the labels, on average
constexpr double kLineHeight = 15;
constexpr double kMarker = 5.5;  // half size
constexpr size_t kColors = 7;

std::string colorOf(size_t style) {
  return fmt::format("var(--series-{})", style % kColors);
}

std::string marker(double x, double y, size_t style) {
  const std::string fill = colorOf(style);
  const auto polygon = [&](const std::vector<std::pair<double, double>>& corners) {
    std::string points;
    for (const auto& [u, v] : corners) {
      points += fmt::format("{:.1f},{:.1f} ", x + u * kMarker, y + v * kMarker);
    }
    return fmt::format(R"(<polygon points="{}" style="fill: {}"/>)", points, fill);
  };
  switch (style % 5) {
    case 0:
      return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" style="fill: {}"/>)", x, y, kMarker, fill);
    case 1:
      return polygon({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
    case 2:
      return polygon({{0, -1.1}, {1.1, 0.9}, {-1.1, 0.9}});
    case 3:
      return polygon({{0, -1.25}, {1.25, 0}, {0, 1.25}, {-1.25, 0}});
    default:
      return polygon({{0, 1.1}, {1.1, -0.9}, {-1.1, -0.9}});
  }
}

std::string dashOf(size_t style) {
  constexpr std::array<const char*, 4> kDashes{"none", "7 3", "2 3", "9 3 2 3"};
  return kDashes[style % kDashes.size()];
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
      most = 1;
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
    for (double value = low_; value <= high_ * 1.0001; value = next(value)) {
      const double mantissa = value / std::pow(10, std::floor(std::log10(value) + 1e-9));
      ticks.emplace_back(value, few || mantissa < 1.5);
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

struct Rectangle {
  double x, y, width, height;

  bool overlaps(const Rectangle& o) const {
    return x < o.x + o.width && o.x < x + width && y < o.y + o.height && o.y < y + height;
  }
};

double textWidth(const std::string& text) {
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
  double bottom() const { return kHeight - kBottom; }
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

/// Beside the marker, where it covers the least of what is there already.
Rectangle placeLabel(double x, double y, const std::string& text, const std::vector<Rectangle>& taken, double right) {
  const double width = textWidth(text);
  const double gap = kMarker + 4;
  const std::array<Rectangle, 8> places{{{x + gap, y - kLineHeight / 2, width, kLineHeight},
                                         {x - gap - width, y - kLineHeight / 2, width, kLineHeight},
                                         {x - width / 2, y - gap - kLineHeight, width, kLineHeight},
                                         {x - width / 2, y + gap, width, kLineHeight},
                                         {x + gap, y - gap - kLineHeight, width, kLineHeight},
                                         {x + gap, y + gap, width, kLineHeight},
                                         {x - gap - width, y - gap - kLineHeight, width, kLineHeight},
                                         {x - gap - width, y + gap, width, kLineHeight}}};
  size_t best = 0;
  size_t fewest = taken.size() + 2;
  for (size_t i = 0; i < places.size(); ++i) {
    const Rectangle& place = places[i];
    const bool outside = place.x < kLeft || place.x + place.width > right || place.y < kTop - kLineHeight;
    const size_t covered = (outside ? taken.size() + 1 : 0) +
                           static_cast<size_t>(std::count_if(taken.begin(), taken.end(),
                                                             [&](const Rectangle& o) { return place.overlaps(o); }));
    if (covered < fewest) {
      fewest = covered;
      best = i;
    }
  }
  return places[best];
}

}  // namespace

std::string frontierPlot(const std::string& title, const std::string& xTitle, const std::string& yTitle,
                         const std::vector<PlotSeries>& series) {
  std::vector<double> counts;
  std::vector<double> errors;
  for (const PlotSeries& each : series) {
    counts.push_back(each.points.front().first);
    errors.push_back(each.points.front().second);
  }
  const double right = kWidth - 24;
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

  std::vector<Rectangle> taken;
  const auto xOf = [&](size_t i) { return horizontal.at(std::max(counts[i], 1.0)); };
  for (size_t i = 0; i < series.size(); ++i) {
    taken.push_back({xOf(i) - kMarker, vertical.at(errors[i]) - kMarker, 2 * kMarker, 2 * kMarker});
  }
  for (size_t i = 0; i < series.size(); ++i) {
    const double x = xOf(i);
    const double y = vertical.at(errors[i]);
    const Rectangle label = placeLabel(x, y, series[i].name, taken, right);
    taken.push_back(label);
    svg += fmt::format(
        "<g><title>{0}: {1:.0f}, {2:.4g} %</title>{3}<text class=\"label\" x=\"{4:.1f}\" "
        "y=\"{5:.1f}\">{0}</text></g>\n",
        htmlFromText(series[i].name), counts[i], 100 * errors[i], marker(x, y, series[i].style), label.x, label.y + 11);
  }
  return svg + "</svg>\n";
}

std::string curvePlot(const std::string& title, const std::string& xTitle, const std::string& yTitle,
                      const std::vector<PlotSeries>& series) {
  std::vector<double> errors;
  double labelWidth = 0;
  for (const PlotSeries& each : series) {
    labelWidth = std::max(labelWidth, textWidth(each.name));
    for (const auto& [x, error] : each.points) {
      errors.push_back(error);
    }
  }
  const double right = kWidth - std::min(labelWidth, kWidth / 3) - 40;
  const ErrorAxis vertical(errors, right);
  const auto xAt = [&](double offset) { return kLeft + (right - kLeft) * offset; };
  std::string svg = opening(title) + vertical.svg(yTitle);
  for (int i = 0; i <= 5; ++i) {
    const double offset = i / 5.0;
    svg += line("grid", xAt(offset), kTop, xAt(offset), vertical.bottom());
    svg += xLabel(xAt(offset), vertical.bottom(), fmt::format("{:g}", offset));
  }
  svg += xTitleText(right, xTitle);

  // Labels stand at the ends of their curves, from the highest down, and push each other apart.
  std::vector<size_t> order;
  for (size_t i = 0; i < series.size(); ++i) {
    if (!series[i].points.empty()) {
      order.push_back(i);
    }
  }
  const auto endOf = [&](size_t i) { return vertical.at(series[i].points.back().second); };
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return endOf(a) < endOf(b); });
  std::vector<double> labelY(order.size());
  double above = kTop - kLineHeight;
  for (size_t rank = 0; rank < order.size(); ++rank) {
    above = std::max(endOf(order[rank]), above + kLineHeight);
    labelY[rank] = above;
  }
  double below = vertical.bottom() + kLineHeight;
  for (size_t rank = order.size(); rank-- > 0;) {
    below = std::min(labelY[rank], below - kLineHeight);
    labelY[rank] = below;
  }
  for (size_t rank = 0; rank < order.size(); ++rank) {
    const PlotSeries& each = series[order[rank]];
    std::string path;
    std::string markers;
    for (const auto& [x, error] : each.points) {
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", xAt(x), vertical.at(error));
    }
    const double end = endOf(order[rank]);
    markers += marker(right, end, each.style);
    svg += fmt::format(
        "<g><title>{0}</title><path d=\"{1}\" style=\"fill: none; stroke: {2}; stroke-width: 2; stroke-dasharray: "
        "{3}\"/>{4}{5}<text class=\"label\" x=\"{6:.1f}\" y=\"{7:.1f}\">{0}</text></g>\n",
        htmlFromText(each.name), path, colorOf(each.style), dashOf(each.style), markers,
        line("leader", right + kMarker + 2, end, right + 20, labelY[rank]), right + 23, labelY[rank] + 4);
  }
  return svg + "</svg>\n";
}

}  // namespace ocelli
