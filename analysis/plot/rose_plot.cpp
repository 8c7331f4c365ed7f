#include "analysis/plot/rose_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "analysis/plot/chart_text.h"
#include "analysis/plot/figure_grid.h"

namespace ocelli {
namespace {

constexpr auto kSectors = static_cast<size_t>(360 / kRoseSectorDegrees);
constexpr double kArcStep = 3;  // degrees, of polylines that stand for arcs
// Points around the circle, for the widest label in the wide fonts that some machines have alone.
constexpr double kLabelRoom = 27;
constexpr double kIntervalAway = 1.06;  // of the arc of the interval, radii
constexpr double kHeadLength = 6;       // of the arrow, points

/// Of trials by sector, the first one around 0.
std::array<int, kSectors> countsOf(const RosePlot::Condition& condition) {
  std::array<int, kSectors> counts{};
  for (const double degrees : condition.degrees) {
    if (std::isfinite(degrees)) {
      const double place = std::floor((degrees + kRoseSectorDegrees / 2) / kRoseSectorDegrees);
      const double rest = std::fmod(std::fmod(place, kSectors) + kSectors, kSectors);
      ++counts[static_cast<size_t>(rest)];
    }
  }
  return counts;
}

class Circle {
 public:
  Circle(PlotPoint center, double radius) : center_(center), radius_(radius) {}

  PlotPoint at(double degrees, double share) const {
    const double angle = degrees * std::numbers::pi / 180;
    return {center_.x + share * radius_ * std::sin(angle), center_.y - share * radius_ * std::cos(angle)};
  }
  std::vector<PlotPoint> arc(double from, double to, double share) const {
    std::vector<PlotPoint> points;
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from) / kArcStep)));
    for (int i = 0; i <= steps; ++i) {
      points.push_back(at(from + (to - from) * i / steps, share));
    }
    return points;
  }

 private:
  PlotPoint center_;
  double radius_;
};

void drawAxes(Drawing& drawing, const Circle& circle) {
  drawing.path("circle", {{circle.arc(0, 360, 1)}, true, std::nullopt, Pen{kAxisPaint, kThinLine}});
  drawing.path("circle", {{circle.arc(0, 360, 0.5)}, true, std::nullopt, Pen{kGridPaint, kThinLine}});
  for (const double degrees : {0.0, 90.0}) {
    drawing.line("axis", circle.at(degrees, 1), circle.at(degrees + 180, 1), {kGridPaint, kThinLine});
  }
  struct Label {
    double degrees;
    const char* text;
    Across across;
    Down down;
  };
  constexpr std::array kLabels{
      Label{0, "0", Across::kMiddle, Down::kBottom}, Label{90, "90", Across::kLeft, Down::kMiddle},
      Label{180, "180", Across::kMiddle, Down::kTop}, Label{270, "\u221290", Across::kRight, Down::kMiddle}};
  for (const Label& label : kLabels) {
    drawing.text("tick label", circle.at(label.degrees, 1.12), label.text,
                 {.size = kTextSize, .paint = kSoftTextPaint, .across = label.across, .down = label.down});
  }
}

void drawMeanArrow(Drawing& drawing, const Circle& circle, const RosePlot::Vector& mean) {
  const PlotPoint from = circle.at(0, 0);
  const PlotPoint to = circle.at(mean.degrees, mean.length);
  drawing.line("mean", from, to, {kWhite, kThickLine + 1.6});
  drawing.line("mean", from, to, {kTextPaint, kThickLine});
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (length < 1e-6) {
    return;
  }
  const double x = (to.x - from.x) / length;
  const double y = (to.y - from.y) / length;
  const double back = std::min(kHeadLength, length);
  const PlotPoint foot{to.x - back * x, to.y - back * y};
  const double half = back / 2.5;
  drawing.path("mean", {{{to, {foot.x - half * y, foot.y + half * x}, {foot.x + half * y, foot.y - half * x}}},
                        true,
                        kTextPaint,
                        std::nullopt});
}

Figure roseOf(const RosePlot::Condition& condition, const SeriesStyle& style, double largestShare, double width) {
  Figure figure{condition.name, "", width * kPointsPerMillimetre, width * kPointsPerMillimetre, {}};
  const std::array<int, kSectors> counts = countsOf(condition);
  int trials = 0;
  for (const int count : counts) {
    trials += count;
  }
  figure.description = fmt::format("{} trials of {} subjects", trials, condition.subjects.size());
  const Circle circle({figure.width / 2, figure.height / 2}, figure.width / 2 - kLabelRoom);
  drawAxes(figure.drawing, circle);
  for (size_t i = 0; i < kSectors && trials > 0; ++i) {
    if (counts[i] == 0) {
      continue;
    }
    // Area in proportion to the share: the radius goes with its root.
    const double radius = std::sqrt(counts[i] / static_cast<double>(trials) / largestShare);
    const double middle = static_cast<double>(i) * kRoseSectorDegrees;
    std::vector<PlotPoint> outline =
        circle.arc(middle - kRoseSectorDegrees / 2, middle + kRoseSectorDegrees / 2, radius);
    outline.push_back(circle.at(0, 0));
    figure.drawing.path("sector", {{outline}, true, style.paint.faded(0.28), Pen{style.paint, kThinLine}});
  }
  const double opacity = std::min(2 * pointOpacity(condition.subjects.size()), 0.8);
  for (const RosePlot::Vector& subject : condition.subjects) {
    figure.drawing.marker("point", {circle.at(subject.degrees, subject.length), style.marker, kPointRadius,
                                    style.paint.faded(opacity), Pen{kWhite, 0.3}});
  }
  if (condition.mean) {
    drawMeanArrow(figure.drawing, circle, *condition.mean);
    figure.description += fmt::format("; mean direction {:.1f} degrees, mean resultant length {:.2f}",
                                      condition.mean->degrees, condition.mean->length);
  }
  if (condition.interval) {
    figure.drawing.polyline("interval",
                            circle.arc(condition.interval->first, condition.interval->second, kIntervalAway),
                            {kTextPaint, kThickLine});
    figure.description +=
        fmt::format(" (direction {:.1f} to {:.1f})", condition.interval->first, condition.interval->second);
  }
  figure.description += '.';
  return figure;
}

}  // namespace

Figure roseFigure(const RosePlot& plot) {
  double largest = 0;
  for (const RosePlot::Condition& condition : plot.conditions) {
    const std::array<int, kSectors> counts = countsOf(condition);
    double trials = 0;
    for (const int count : counts) {
      trials += count;
    }
    if (trials > 0) {
      largest = std::max(largest, *std::max_element(counts.begin(), counts.end()) / trials);
    }
  }
  if (largest == 0) {
    return emptyFigure(plot.title, kDoubleColumnMillimetres, "no trial holds a direction");
  }
  FigureGrid grid;
  grid.title = plot.title;
  grid.columns = plot.conditions.size() > 4 ? 4 : std::max<size_t>(plot.conditions.size(), 2);
  const double width = std::min(grid.columnMillimetres(), kSingleColumnMillimetres * 0.8);
  for (size_t i = 0; i < plot.conditions.size(); ++i) {
    grid.figures.push_back(roseOf(plot.conditions[i], seriesStyle(i), largest, width));
  }
  return gridFigure(grid);
}

}  // namespace ocelli
